// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/RefinementFit.hpp"

#include "base/CaseError.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace slosh
{
namespace
{

Refinement refinementOf(const std::vector<double>& h, const std::function<double(double)>& phi)
{
    Refinement study{h, Eigen::MatrixXd(std::ssize(h), 1)};
    for (std::size_t i = 0; i < h.size(); ++i)
    {
        study.phi(static_cast<Eigen::Index>(i), 0) = phi(h[i]);
    }
    return study;
}

const std::vector<double> spacings{0.01, 0.0143, 0.02, 0.0313, 0.04};

TEST(RefinementFit, FindsLimitAndOrderOfAnExactPower)
{
    for (const double p : {0.5, 1.0, 1.5, 2.0, 3.7, -1.0})
    {
        for (const bool isWeighted : {false, true})
        {
            for (const double unit : {1.0, 1e-3, 1e3})
            {
                auto h = spacings;
                for (double& each : h)
                {
                    each *= 100 * unit;
                }
                const auto fit =
                    fitWithOrder(refinementOf(h, [&](double x) { return 1 + 2 * std::pow(x / unit, p); }), isWeighted);
                EXPECT_NEAR(fit.exponents.front(), p, 1e-6);
                EXPECT_NEAR(fit.limit(0), 1, 1e-8);
                EXPECT_NEAR(fit.error(h[2])(0) / (2 * std::pow(2, p)), 1, 1e-7);
                EXPECT_NEAR(fit.standardDeviation, 0, 1e-8);
            }
        }
    }
}

TEST(RefinementFit, FindsTheTermsOfAnExactSum)
{
    const auto study = refinementOf(spacings, [](double h) { return -3 + 4 * h - 70 * h * h; });
    const auto fit = fitWithExponents(study, {1, 2}, true);
    EXPECT_NEAR(fit.limit(0), -3, 1e-12);
    EXPECT_NEAR(fit.coefficients(0, 0), 4, 1e-10);
    EXPECT_NEAR(fit.coefficients(1, 0), -70, 1e-8);
    EXPECT_NEAR(fit(0.02)(0), -3 + 0.08 - 0.028, 1e-12);
}

// The line of least squares through (1, 0), (2, 3), (3, 0): phi = 1, residuals -1, 2, -1, sigma^2 = 6/(3 - 2). With the
// weights 1, 1/2, 1/3, whose mean is 11/18, the normal equations 11/6 a + 3 b = 3/2, 3 a + 6 b = 3 give phi = h/2;
// residuals -1/2, 2, -3/2, sigma^2 = 18/11 (1/4 + 2 + 3/4) = 54/11.
TEST(RefinementFit, HasTheStandardDeviationOfItsDefinition)
{
    Refinement study{{1, 2, 3}, Eigen::Vector3d(0, 3, 0)};
    const auto plain = fitWithExponents(study, {1}, false);
    EXPECT_NEAR(plain.limit(0), 1, 1e-14);
    EXPECT_NEAR(plain.coefficients(0, 0), 0, 1e-14);
    EXPECT_NEAR(plain.standardDeviation, std::sqrt(6.0), 1e-14);
    const auto weighted = fitWithExponents(study, {1}, true);
    EXPECT_NEAR(weighted.limit(0), 0, 1e-13);
    EXPECT_NEAR(weighted.coefficients(0, 0), 0.5, 1e-13);
    EXPECT_NEAR(weighted.standardDeviation, std::sqrt(54.0 / 11), 1e-13);
}

TEST(RefinementFit, OfASeriesHasOneOrderForAllInstants)
{
    Refinement study{spacings, Eigen::MatrixXd(5, 40)};
    for (Eigen::Index i = 0; i < 5; ++i)
    {
        for (Eigen::Index t = 0; t < 40; ++t)
        {
            const auto x = static_cast<double>(t);
            study.phi(i, t) = std::sin(x) + 30 * std::cos(2 * x) * std::pow(spacings[static_cast<std::size_t>(i)], 1.3);
        }
    }
    const auto fit = fitWithOrder(study, true);
    EXPECT_NEAR(fit.exponents.front(), 1.3, 1e-6);
    for (Eigen::Index t = 0; t < 40; ++t)
    {
        EXPECT_NEAR(fit.limit(t), std::sin(static_cast<double>(t)), 1e-8);
    }
}

TEST(RefinementFit, RefusesWhatHasNoFit)
{
    const auto one = [](double) { return 1.0; };
    EXPECT_THROW(fitWithOrder(refinementOf({1, 2, 3}, one), false), CaseError);
    EXPECT_THROW(fitWithExponents(refinementOf({1, 2}, one), {1}, false), CaseError);
    EXPECT_THROW(fitWithExponents(refinementOf({1, 3, 2}, one), {1}, false), CaseError);
    EXPECT_THROW(fitWithExponents(refinementOf({1, 2, 2}, one), {1}, false), CaseError);
    EXPECT_THROW(fitWithExponents(refinementOf({0, 1, 2}, one), {1}, false), CaseError);
    EXPECT_THROW(fitWithExponents(refinementOf({1, 2, 3}, [](double) { return NAN; }), {1}, false), CaseError);
    EXPECT_THROW(fitWithExponents({{1, 2, 3}, Eigen::Vector2d(1, 2)}, {1}, false), CaseError);
}

} // namespace
} // namespace slosh
