// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/numericalUncertainty.hpp"

#include "base/CaseError.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <random>

namespace slosh
{
namespace
{

constexpr double order = 2; // of the scheme

Refinement refinementOf(const std::vector<double>& h, const std::function<double(double)>& phi)
{
    Refinement study{h, Eigen::MatrixXd(std::ssize(h), 1)};
    for (std::size_t i = 0; i < h.size(); ++i)
    {
        study.phi(static_cast<Eigen::Index>(i), 0) = phi(h[i]);
    }
    return study;
}

TEST(NumericalUncertainty, OfAnExactOrderIsTheErrorTimesTheSafetyFactor)
{
    const auto found = numericalUncertainty(
        refinementOf({0.2, 0.3, 0.4, 0.6}, [](double h) { return 1 + 2 * std::pow(h, 1.5); }), {}, order
    );
    EXPECT_TRUE(found.isOrderKept);
    EXPECT_NEAR(found.order, 1.5, 1e-6);
    EXPECT_NEAR(found.fit.limit(0), 1, 1e-8);
    EXPECT_EQ(found.safetyFactor, 1.25);
    EXPECT_NEAR(found.discretisation, 1.25 * 2 * std::pow(0.2, 1.5), 1e-7);
    EXPECT_NEAR(found.dataRange, 2 * (std::pow(0.6, 1.5) - std::pow(0.2, 1.5)) / 3, 1e-14);
    EXPECT_NEAR(found.change, 2 * (std::pow(0.3, 1.5) - std::pow(0.2, 1.5)), 1e-14);
    EXPECT_FALSE(found.isChange);
    EXPECT_EQ(found.scatter, 0);
    EXPECT_EQ(found.total(), found.discretisation);
}

// An order above the scheme's is not believed: the fit is the better one of h and h^2, the factor 3.
TEST(NumericalUncertainty, KeepsTheOrderBetweenAHalfAndTheSchemes)
{
    const auto high =
        numericalUncertainty(refinementOf({1, 1.4, 2, 2.8}, [](double h) { return std::pow(h, 4); }), {}, order);
    EXPECT_FALSE(high.isOrderKept);
    EXPECT_NEAR(high.order, 4, 1e-6);
    EXPECT_EQ(high.safetyFactor, 3);
    EXPECT_EQ(high.fit.exponents, std::vector<double>{2});
    EXPECT_GT(high.discretisation, high.change);

    const auto low =
        numericalUncertainty(refinementOf({1, 1.4, 2, 2.8}, [](double h) { return std::pow(h, 0.2); }), {}, order);
    EXPECT_FALSE(low.isOrderKept);
    EXPECT_NEAR(low.order, 0.2, 1e-6);
    EXPECT_EQ(low.safetyFactor, 3);
    EXPECT_EQ(low.fit.exponents, (std::vector<double>{1, 2})) << "the one with most freedom follows best";

    // 2.05 is the scheme's order within the tolerance: fixed exponents, but the factor of a good fit.
    const auto justAbove =
        numericalUncertainty(refinementOf({1, 1.4, 2, 2.8}, [](double h) { return std::pow(h, 2.05); }), {}, order);
    EXPECT_FALSE(justAbove.isOrderKept);
    EXPECT_EQ(justAbove.safetyFactor, 1.25);
    EXPECT_EQ(justAbove.fit.exponents, std::vector<double>{2});
    // And it is the scheme's order that decides.
    const auto first =
        numericalUncertainty(refinementOf({1, 1.4, 2, 2.8}, [](double h) { return std::pow(h, 1.5); }), {}, 1);
    EXPECT_FALSE(first.isOrderKept);
    EXPECT_EQ(first.fit.exponents, std::vector<double>{1});
}

// The figures -1, 1, -1, 1 have no order; the range is 2/3, sigma of any fit is larger.
TEST(NumericalUncertainty, OfFiguresThatDoNotFollowTheFitGrowsWithTheirScatter)
{
    const Refinement study{{1, 1.2, 1.44, 1.728}, Eigen::Vector4d(-1, 1, -1, 1)};
    const auto found = numericalUncertainty(study, {}, order);
    const double sigma = found.fit.standardDeviation;
    EXPECT_FALSE(found.isFollowed());
    EXPECT_GT(sigma, found.dataRange);
    EXPECT_NEAR(found.dataRange, 2.0 / 3, 1e-15);
    EXPECT_EQ(found.safetyFactor, 3);
    EXPECT_NEAR(
        found.discretisation, 3 * sigma / found.dataRange * (found.error + sigma + found.deviation + found.otherLimit),
        1e-12
    );
    EXPECT_GE(found.discretisation, found.change);
}

// What an order of 8.6 on three grids said of a figure that a fourth moved by a fifth.
TEST(NumericalUncertainty, IsNoSmallerThanTheLastChangeUnlessTheFitHasEarnedIt)
{
    const auto lucky = numericalUncertainty({{1, 1.4, 2, 2.8}, Eigen::Vector4d(2.2, 2, 2, 2)}, {}, order);
    EXPECT_GE(lucky.discretisation, 0.2);
    // Spacings far apart and an exact order: the last change is three times the error, and the fit has earned less.
    const auto earned =
        numericalUncertainty(refinementOf({1, 2, 4, 8}, [](double h) { return 1 + h * h / 10; }), {}, order);
    EXPECT_NEAR(earned.change, 0.3, 1e-12);
    EXPECT_NEAR(earned.discretisation, 0.125, 1e-6);
    EXPECT_FALSE(earned.isChange);
    // The same figures, known to +- 0.2 only.
    const auto scattered = numericalUncertainty(
        refinementOf({1, 2, 4, 8}, [](double h) { return 1 + h * h / 10; }), {0.2, 0.2, 0.2, 0.2}, order
    );
    EXPECT_GE(scattered.discretisation, 0.3 * (1 - 1e-12));
}

TEST(NumericalUncertainty, OfAFigureThatDoesNotChangeIsNothing)
{
    const auto found = numericalUncertainty(refinementOf({1, 2, 3, 4}, [](double) { return 5.0; }), {}, order);
    EXPECT_NEAR(found.total(), 0, 1e-12);
    EXPECT_NEAR(found.fit.limit(0), 5, 1e-12);
}

TEST(NumericalUncertainty, DoesNotDependOnUnits)
{
    const auto phi = [](double h) { return 1 + h - 0.3 * h * h + 0.02 * std::sin(20 * h); };
    const std::vector<double> h{0.5, 0.7, 1, 1.3, 2};
    const auto found = numericalUncertainty(refinementOf(h, phi), {0.01, 0.02, 0.01, 0.02, 0.01}, order);
    auto small = h;
    std::transform(h.begin(), h.end(), small.begin(), [](double each) { return 1e-3 * each; });
    const auto other = numericalUncertainty(
        refinementOf(small, [&](double x) { return 1e5 * phi(1e3 * x); }), {1e3, 2e3, 1e3, 2e3, 1e3}, order
    );
    EXPECT_NEAR(other.order / found.order, 1, 1e-6);
    EXPECT_NEAR(other.discretisation / (1e5 * found.discretisation), 1, 1e-6);
    EXPECT_NEAR(other.scatter / (1e5 * found.scatter), 1, 1e-5);
}

// phi = phi0 + a h: the limit is known to be first order, so that the scatter is carried by a straight line.
TEST(NumericalUncertainty, CarriesTheScatterOfEachFigureToTheError)
{
    const auto study = refinementOf({1, 2, 3, 4}, [](double h) { return h; });
    const auto none = numericalUncertainty(study, {0, 0, 0, 0}, order);
    EXPECT_EQ(none.scatter, 0);
    const auto some = numericalUncertainty(study, {0.01, 0.01, 0.01, 0.01}, order);
    EXPECT_GT(some.scatter, 0.01);
    EXPECT_NEAR(some.total(), std::hypot(some.discretisation, some.scatter), 1e-15);
    EXPECT_EQ(some.discretisation, none.discretisation);
    EXPECT_GT(numericalUncertainty(study, {0.02, 0.02, 0.02, 0.02}, order).scatter, some.scatter);
}

TEST(NumericalUncertainty, RefusesFewerThanFourSpacings)
{
    const auto one = [](double) { return 1.0; };
    EXPECT_THROW(numericalUncertainty(refinementOf({1, 2, 3}, one), {}, order), CaseError);
    EXPECT_THROW(numericalUncertainty(refinementOf({1, 2, 3, 4}, one), {0.1}, order), CaseError);
    EXPECT_THROW(numericalUncertainty(refinementOf({1, 2, 3, 4}, one), {}, 0.5), CaseError);
    EXPECT_THROW(numericalUncertainty({{1, 2, 3, 4}, Eigen::MatrixXd::Ones(4, 2)}, {1, 1, 1, 1}, order), CaseError);
}

/// Four to six spacings with ratios of 1.2 to 1.6, as those of particles that fit a tank: not quite alike. The coarsest
/// is 1.
std::vector<double> someSpacings(std::mt19937_64& random)
{
    std::uniform_real_distribution<double> share(0, 1);
    const auto n = 4 + static_cast<std::size_t>(3 * share(random));
    const double ratio = 1.2 + 0.4 * share(random);
    std::vector<double> h(n, 1);
    for (std::size_t i = n - 1; i > 0; --i)
    {
        h[i - 1] = h[i] / (ratio * (0.985 + 0.03 * share(random)));
    }
    return h;
}

struct Draw
{
    Refinement study;
    std::vector<double> scatter;
    double truth = 0;
};

/// A value to converge to, and an order.
struct Drawn
{
    double truth, p, a;

    explicit Drawn(std::mt19937_64& random)
    {
        std::normal_distribution<double> normal;
        std::uniform_real_distribution<double> share(0, 1);
        truth = 10 * normal(random);
        p = 0.5 + 1.5 * share(random);
        a = share(random) < 0.5 ? -1 : 1;
    }
    double error(double h) const { return a * std::pow(h, p); }
};

Draw exact(std::mt19937_64& random)
{
    const Drawn drawn(random);
    return {
        refinementOf(someSpacings(random), [&](double h) { return drawn.truth + drawn.error(h); }), {}, drawn.truth};
}

/// Within a noise that nobody knows, a hundredth of the finest error.
Draw nearlyExact(std::mt19937_64& random)
{
    const Drawn drawn(random);
    const auto h = someSpacings(random);
    std::normal_distribution<double> noise(0, 0.01 * std::abs(drawn.error(h.front())));
    return {refinementOf(h, [&](double x) { return drawn.truth + drawn.error(x) + noise(random); }), {}, drawn.truth};
}

/// a1 h + a2 h^2 of any signs: of one sign, or turning.
Draw mixed(std::mt19937_64& random)
{
    const Drawn drawn(random);
    std::normal_distribution<double> normal;
    const double a1 = normal(random), a2 = normal(random);
    return {
        refinementOf(someSpacings(random), [&](double h) { return drawn.truth + a1 * h + a2 * h * h; }),
        {},
        drawn.truth};
}

Draw oscillating(std::mt19937_64& random)
{
    const Drawn drawn(random);
    double sign = 1;
    return {
        refinementOf(
            someSpacings(random),
            [&](double h)
            {
                sign = -sign;
                return drawn.truth + sign * drawn.error(h);
            }
        ),
        {},
        drawn.truth};
}

/// Means of 5 to 30 periods, with the half widths that these give. `level`: the standard error over the last change of
/// the means that many periods would have.
Draw noisy(std::mt19937_64& random, double lowest, double highest)
{
    // Student's t of 95 % with n - 1 degrees of freedom, within 1e-3 by Cornish and Fisher's expansion from 4 on.
    const auto t = [](double nu)
    {
        const double z = 1.959964;
        return z + (std::pow(z, 3) + z) / (4 * nu) +
               (5 * std::pow(z, 5) + 16 * std::pow(z, 3) + 3 * z) / (96 * nu * nu) +
               (3 * std::pow(z, 7) + 19 * std::pow(z, 5) + 17 * std::pow(z, 3) - 15 * z) / (384 * std::pow(nu, 3));
    };
    const Drawn drawn(random);
    std::uniform_real_distribution<double> share(0, 1);
    std::normal_distribution<double> normal;
    const auto h = someSpacings(random);
    const double level = lowest * std::pow(highest / lowest, share(random));
    const double standardError = level * std::abs(drawn.error(h[1]) - drawn.error(h[0]));
    std::vector<double> halfWidths;
    const auto mean = [&](double x)
    {
        const auto n = 5 + static_cast<std::size_t>(26 * share(random));
        const auto count = static_cast<double>(n);
        std::vector<double> periods(n);
        for (double& each : periods)
        {
            each = drawn.truth + drawn.error(x) + standardError * std::sqrt(count) * normal(random);
        }
        const double middle = std::accumulate(periods.begin(), periods.end(), 0.0) / count;
        double squares = 0;
        for (const double each : periods)
        {
            squares += (each - middle) * (each - middle);
        }
        halfWidths.push_back(t(count - 1) * std::sqrt(squares / (count - 1) / count));
        return middle;
    };
    auto study = refinementOf(h, mean);
    return {std::move(study), std::move(halfWidths), drawn.truth};
}

struct Family
{
    const char* name;
    std::function<Draw(std::mt19937_64&)> draw;
    double highestMedian; ///< of U over the true error
};

class Coverage : public testing::TestWithParam<Family>
{
};

TEST_P(Coverage, HoldsTheTruthInNineteenOfTwentyDrawsAndIsNotSimplyWide)
{
    constexpr int draws = 1000;
    std::mt19937_64 random(2014);
    int inside = 0;
    std::vector<double> widths;
    for (int i = 0; i < draws; ++i)
    {
        const Draw one = GetParam().draw(random);
        const double U = numericalUncertainty(one.study, one.scatter, order).total();
        const double error = std::abs(one.study.phi(0, 0) - one.truth);
        inside += U >= error;
        widths.push_back(U / error);
    }
    std::nth_element(widths.begin(), widths.begin() + draws / 2, widths.end());
    RecordProperty("inside", inside);
    RecordProperty("median", std::to_string(widths[draws / 2]));
    EXPECT_GE(inside, 0.95 * draws);
    EXPECT_LE(widths[draws / 2], GetParam().highestMedian);
    EXPECT_GE(widths[draws / 2], 1);
}

INSTANTIATE_TEST_SUITE_P(
    LongFamilies, Coverage,
    testing::Values(
        Family{"exact", exact, 1.2501}, Family{"nearlyExact", nearlyExact, 1.4}, Family{"mixed", mixed, 1.75},
        Family{"oscillating", oscillating, 20},
        Family{"littleNoise", [](std::mt19937_64& random) { return noisy(random, 0.01, 0.1); }, 1.5},
        Family{"noise", [](std::mt19937_64& random) { return noisy(random, 0.1, 1); }, 3.5},
        Family{"muchNoise", [](std::mt19937_64& random) { return noisy(random, 1, 10); }, 15}
    ),
    [](const auto& info) { return std::string(info.param.name); }
);

} // namespace
} // namespace slosh
