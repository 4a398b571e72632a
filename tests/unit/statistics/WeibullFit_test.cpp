// SPDX-License-Identifier: GPL-3.0-or-later
#include "statistics/WeibullFit.hpp"

#include "base/CaseError.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace slosh
{
namespace
{

using std::numbers::pi;

/// The values exceeded with the probabilities (k + 1/2)/n.
std::vector<double> quantiles(const Weibull& weibull, int n)
{
    std::vector<double> samples;
    for (int k = 0; k < n; ++k)
    {
        samples.push_back(weibull.valueExceededBy((k + 0.5) / n));
    }
    return samples;
}

std::vector<double> drawn(const Weibull& weibull, int n, std::uint64_t seed)
{
    std::mt19937_64 random(seed);
    std::vector<double> samples;
    for (int k = 0; k < n; ++k)
    {
        samples.push_back(weibull.valueExceededBy((static_cast<double>(random() >> 11) + 0.5) * 0x1p-53));
    }
    return samples;
}

double logLikelihood(const std::vector<double>& samples, const Weibull& w)
{
    double sum = 0;
    for (const double x : samples)
    {
        const double y = (x - w.location) / w.scale;
        sum += std::log(w.shape / w.scale) + (w.shape - 1) * std::log(y) - std::pow(y, w.shape);
    }
    return sum;
}

/// The same with scale and shape times exp(a), exp(b).
Weibull moved(const Weibull& w, double a, double b)
{
    return {w.location, w.scale * std::exp(a), w.shape * std::exp(b)};
}

TEST(Weibull, IsTheExponentialAndTheRayleighDistributionForShapesOneAndTwo)
{
    EXPECT_DOUBLE_EQ((Weibull{100, 50, 1}.exceedance(200)), std::exp(-2.0));
    EXPECT_DOUBLE_EQ((Weibull{0, 50, 2}.exceedance(100)), std::exp(-4.0));
    EXPECT_EQ((Weibull{100, 50, 2}.exceedance(90)), 1);
    EXPECT_DOUBLE_EQ((Weibull{100, 50, 2}.valueExceededBy(std::exp(-9.0))), 250);
    const Weibull weibull{3, 2, 0.7};
    EXPECT_NEAR(weibull.exceedance(weibull.valueExceededBy(0.01)), 0.01, 1e-15);
}

TEST(WeibullFit, OfTwoDistinctValuesIsTheRootOfATanhA)
{
    // y = exp(+-s), as many of each: beta s tanh(beta s) = 1, eta^beta = cosh(beta s).
    const double root = 1.1996786402577338, s = 0.4;
    const WeibullFit fit({std::exp(s), std::exp(-s), std::exp(s), std::exp(-s), std::exp(s), std::exp(-s)}, 0);
    EXPECT_NEAR(fit.distribution().shape, root / s, 1e-13);
    EXPECT_NEAR(fit.distribution().scale, std::pow(std::cosh(root), s / root), 1e-14);
    EXPECT_EQ(fit.distribution().location, 0);
}

TEST(WeibullFit, OfTheBallBearingsOfLiebleinAndZelenIsThePublishedOne)
{
    // Millions of revolutions to failure (Lieblein & Zelen 1956); the fit of Lawless 1982, section 4.1: 2.10, 81.9.
    const WeibullFit fit(
        {17.88, 28.92, 33.00, 41.52, 42.12, 45.60, 48.48,  51.84,  51.96,  54.12,  55.56, 67.80,
         68.64, 68.64, 68.88, 84.12, 93.12, 98.64, 105.12, 105.84, 127.92, 128.04, 173.40},
        0
    );
    EXPECT_NEAR(fit.distribution().shape, 2.10, 0.005);
    EXPECT_NEAR(fit.distribution().scale, 81.9, 0.05);
}

TEST(WeibullFit, MaximisesTheLikelihood)
{
    for (const double shape : {0.4, 1.0, 3.5, 40.0})
    {
        const auto samples = drawn({500, 300, shape}, 40, 7);
        const Weibull w = WeibullFit(samples, 500).distribution();
        const double most = logLikelihood(samples, w);
        for (const auto& [a, b] : {std::pair{1e-3, 0.0}, {-1e-3, 0.0}, {0.0, 1e-3}, {0.0, -1e-3}, {7e-4, 7e-4}})
        {
            EXPECT_LT(logLikelihood(samples, moved(w, a, b)), most) << shape;
        }
        // The gradient, by central differences, against the curvature along each axis, at least n.
        const double h = 1e-4;
        EXPECT_NEAR(
            (logLikelihood(samples, moved(w, h, 0)) - logLikelihood(samples, moved(w, -h, 0))) / (2 * h), 0,
            1e-3 * std::max(1.0, shape * shape)
        );
        EXPECT_NEAR(
            (logLikelihood(samples, moved(w, 0, h)) - logLikelihood(samples, moved(w, 0, -h))) / (2 * h), 0, 1e-3
        );
    }
}

TEST(WeibullFit, FollowsShiftScaleAndPowerOfTheSamples)
{
    const auto samples = drawn({0, 1, 1.3}, 30, 3);
    const Weibull w = WeibullFit(samples, 0).distribution();
    std::vector<double> scaled, power;
    for (const double x : samples)
    {
        scaled.push_back(250 + 1e7 * x);
        power.push_back(std::pow(x, 100)); // over hundreds of decades
    }
    const Weibull wScaled = WeibullFit(scaled, 250).distribution(), wPower = WeibullFit(power, 0).distribution();
    EXPECT_NEAR(wScaled.shape / w.shape, 1, 1e-9);
    EXPECT_NEAR(wScaled.scale / w.scale / 1e7, 1, 1e-9);
    EXPECT_NEAR(wPower.shape * 100 / w.shape, 1, 1e-11);
    EXPECT_NEAR(std::log(wPower.scale) / (100 * std::log(w.scale)), 1, 1e-11);
}

TEST(WeibullFit, OfQuantilesConvergesToTheirDistribution)
{
    for (const double shape : {0.6, 1.0, 2.5})
    {
        const Weibull exact{500, 300, shape};
        const auto error = [&](int n)
        { return std::abs(WeibullFit(quantiles(exact, n), 500).distribution().shape / shape - 1); };
        EXPECT_LT(error(10000), 2e-3);
        EXPECT_GT(error(100) / error(10000), 30); // about 1/n, with a logarithm
        EXPECT_LT(error(100) / error(10000), 120);
        const Weibull w = WeibullFit(quantiles(exact, 10000), 500).distribution();
        EXPECT_NEAR(w.scale, 300, 0.3);
        EXPECT_NEAR(w.valueExceededBy(0.01) / exact.valueExceededBy(0.01), 1, 5e-3);
    }
}

TEST(WeibullFit, HasTheBoundsOfTheFisherInformation)
{
    const int n = 64;
    const WeibullFit fit(drawn({100, 20, 1.7}, n, 5), 100);
    const double beta = fit.distribution().shape;
    // Normal quantiles of the tables.
    for (const auto& [confidence, z] :
         {std::pair{0.5, 0.674489750196082},
          {0.9, 1.644853626951473},
          {0.95, 1.959963984540054},
          {0.99, 2.575829303548901},
          {0.999999, 4.891638475698725}})
    {
        const ConfidenceInterval shape = fit.shape(confidence), scale = fit.scale(confidence);
        EXPECT_NEAR(std::log(shape.high / shape.value) * std::sqrt(n) * pi / std::sqrt(6.0), z, 1e-9);
        EXPECT_NEAR(std::log(shape.value / shape.low) * std::sqrt(n) * pi / std::sqrt(6.0), z, 1e-9);
        // 1.108665: the asymptotic variance of ln eta, times n beta^2 (Cohen 1965 and any table since).
        EXPECT_NEAR(std::log(scale.high / scale.value) * std::sqrt(n) * beta / std::sqrt(1.108665), z, 1e-5);
        // Exceeded by 1/e is the scale itself, with its bounds.
        const ConfidenceInterval value = fit.valueExceededBy(std::exp(-1.0), confidence);
        EXPECT_NEAR(value.low, 100 + scale.low, 1e-10);
        EXPECT_NEAR(value.value, 100 + scale.value, 1e-10);
        EXPECT_NEAR(value.high, 100 + scale.high, 1e-10);
    }
    // The best known value is where ln(-ln p) = 1 - gamma: its variance is 1/(n beta^2).
    const ConfidenceInterval best = fit.valueExceededBy(std::exp(-std::exp(1 - std::numbers::egamma)), 0.95);
    EXPECT_NEAR(std::log((best.high - 100) / (best.value - 100)), 1.959963984540054 / (std::sqrt(n) * beta), 1e-12);
}

TEST(WeibullFit, BoundsHoldTheTrueValueAsOftenAsTheConfidenceSays)
{
    const Weibull exact{500, 300, 1.2};
    const int runs = 4000;
    int shape = 0, scale = 0, value = 0;
    const auto holds = [](const ConfidenceInterval& estimate, double x)
    { return estimate.low <= x && x <= estimate.high; };
    for (int seed = 0; seed < runs; ++seed)
    {
        const WeibullFit fit(drawn(exact, 200, static_cast<std::uint64_t>(seed)), 500);
        shape += holds(fit.shape(0.9), exact.shape);
        scale += holds(fit.scale(0.9), exact.scale);
        value += holds(fit.valueExceededBy(0.01, 0.9), exact.valueExceededBy(0.01));
    }
    // 4 standard deviations of a count of 4000, 1.9 %, contain it; bounds of 88 % or 92 % would be outside.
    for (const int count : {shape, scale, value})
    {
        EXPECT_NEAR(static_cast<double>(count) / runs, 0.9, 0.019);
    }
}

TEST(WeibullFit, GivesTheMostProbableMaximumOfExponentialPeaks)
{
    // Two values whose fit has the shape 1 (see above). The largest of N has the density N F^(N-1) f.
    const double s = 1.1996786402577338;
    const WeibullFit fit({std::exp(s), std::exp(-s), std::exp(s), std::exp(-s), std::exp(s), std::exp(-s)}, 0);
    const Weibull w = fit.distribution();
    ASSERT_NEAR(w.shape, 1, 1e-12);
    const int N = 50;
    const auto density = [&](double x) { return std::pow(1 - w.exceedance(x), N - 1) * w.exceedance(x); };
    const double mode = fit.valueExceededBy(1.0 / N, 0.95).value;
    EXPECT_GT(density(mode), density(mode * 1.001));
    EXPECT_GT(density(mode), density(mode * 0.999));
}

TEST(WeibullFit, SaysWhyThereIsNone)
{
    EXPECT_EQ(WeibullFit::obstacle({1, 2, 3}, 0), "a Weibull fit needs 5 values; there are 3");
    EXPECT_EQ(WeibullFit::obstacle({7, 7, 7, 7, 7}, 0), "a Weibull fit needs different values; all are 7");
    EXPECT_EQ(
        WeibullFit::obstacle({3, 4, 5, 6, 7}, 3), "a Weibull fit needs values above its location, 3; the smallest is 3"
    );
    EXPECT_EQ(WeibullFit::obstacle({3, 4, 5, 6, 7}, 2), "");
    EXPECT_THROW(WeibullFit({1, 2, 3}, 0), CaseError);
    EXPECT_THROW(WeibullFit({7, 7, 7, 7, 7}, 0), CaseError);
    const WeibullFit fit({3, 4, 5, 6, 7}, 2);
    for (const double p : {0.0, 1.0, -0.1, std::nan("")})
    {
        EXPECT_THROW(fit.shape(p), CaseError);
        EXPECT_THROW(fit.valueExceededBy(p, 0.95), CaseError);
    }
}

} // namespace
} // namespace slosh
