// SPDX-License-Identifier: GPL-3.0-or-later
#include "statistics/Spectrum.hpp"

#include "base/CaseError.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

namespace slosh
{
namespace
{

constexpr double pi = std::numbers::pi;

/// n samples, `dt` apart from t = 3 s on.
TimeSeries samples(std::size_t n, double dt, const std::function<double(double)>& f)
{
    TimeSeries series;
    for (std::size_t j = 0; j < n; ++j)
    {
        series.t.push_back(3 + dt * static_cast<double>(j));
        series.value.push_back(f(dt * static_cast<double>(j)));
    }
    return series;
}

double power(const Spectrum& spectrum)
{
    double sum = 0;
    for (const double density : spectrum.density)
    {
        sum += density * spectrum.step;
    }
    return sum;
}

TEST(Spectrum, OfASineOfWholePeriodsIsThreeLinesThatHoldItsMeanSquare)
{
    for (const std::size_t n : {400u, 405u, 512u}) // even, odd, a power of two
    {
        const double dt = 0.01, omega = 2 * pi * 12 / (static_cast<double>(n) * dt), A = 3;
        const Spectrum spectrum(samples(n, dt, [&](double t) { return 7 + A * std::sin(omega * t + 0.4); }));
        ASSERT_EQ(spectrum.density.size(), n / 2 + 1);
        EXPECT_NEAR(spectrum.omega(12), omega, 1e-9);
        const double square = A * A / 2 / spectrum.step;
        for (std::size_t k = 0; k < spectrum.density.size(); ++k)
        {
            const double expected = k == 12 ? square * 2 / 3 : k == 11 || k == 13 ? square / 6 : 0;
            EXPECT_NEAR(spectrum.density[k], expected, 1e-9 * square) << n << " line " << k;
        }
        EXPECT_NEAR(spectrum.strongest(), omega, 1e-9);
    }
}

TEST(Spectrum, HoldsTheMeanSquareOfAnySeriesUnderItsWindow)
{
    // Parseval, with the numbers of a generator of old as noise.
    unsigned state = 1;
    const auto noise = [&](double)
    {
        state = state * 1664525u + 1013904223u;
        return static_cast<double>(state) / 4294967296.0;
    };
    for (const std::size_t n : {16u, 81u, 1000u})
    {
        const TimeSeries series = samples(n, 0.5, noise);
        double sum = 0, mean = 0, squares = 0, power2 = 0;
        const auto w = [&](std::size_t j)
        { return 1 - std::cos(2 * pi * static_cast<double>(j) / static_cast<double>(n)); };
        for (std::size_t j = 0; j < n; ++j)
        {
            sum += w(j);
            mean += w(j) * series.value[j];
            squares += w(j) * w(j);
        }
        for (std::size_t j = 0; j < n; ++j)
        {
            power2 += std::pow(w(j) * (series.value[j] - mean / sum), 2);
        }
        EXPECT_NEAR(power(Spectrum(series)), power2 / squares, 1e-12 * power2 / squares) << n;
        EXPECT_NEAR(Spectrum(series).density[0], 0, 1e-12 * power2);
    }
}

TEST(Spectrum, FindsAFrequencyBetweenItsLinesToAHundredthOfTheirDistance)
{
    for (double periods = 3; periods < 40; periods += 0.193)
    {
        const std::size_t n = 600;
        const double dt = 0.02, omega = 2 * pi * periods / (static_cast<double>(n) * dt);
        const Spectrum spectrum(samples(n, dt, [&](double t) { return std::cos(omega * t); }));
        EXPECT_NEAR(spectrum.strongest(), omega, 0.01 * spectrum.step) << periods << " periods";
    }
}

TEST(Spectrum, TakesSamplesOfUnevenDistancesAndOfANumberThatNoTransformLikes)
{
    // 4099 is a prime. The distances vary by a factor of three.
    TimeSeries series;
    for (int j = 0; j < 4099; ++j)
    {
        const double s = 0.005 * j;
        series.t.push_back(s + 0.025 * std::sin(20 * s));
        series.value.push_back(2 * std::sin(4 * series.t.back()));
    }
    const Spectrum spectrum(series);
    EXPECT_NEAR(spectrum.strongest(), 4, 0.02 * spectrum.step);
    EXPECT_NEAR(power(spectrum), 2, 0.01);
}

TEST(Spectrum, OfAConstantIsNothingAndOfTooFewSamplesIsRefused)
{
    const auto constant = [](double) { return 5.0; };
    EXPECT_NEAR(power(Spectrum(samples(100, 0.1, constant))), 0, 1e-20);
    EXPECT_THROW(Spectrum(samples(15, 0.1, constant)), CaseError);
    EXPECT_NO_THROW(Spectrum(samples(16, 0.1, constant)));
}

} // namespace
} // namespace slosh
