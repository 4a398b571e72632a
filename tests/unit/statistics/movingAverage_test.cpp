// SPDX-License-Identifier: GPL-3.0-or-later
#include "statistics/movingAverage.hpp"

#include "base/CaseError.hpp"
#include "statistics/Integral.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

namespace slosh
{
namespace
{

/// n + 1 unevenly spaced samples of f from 0 to 10 s, the spacing varying by a factor of 3.
TimeSeries uneven(int n, const std::function<double(double)>& f)
{
    TimeSeries series;
    for (int k = 0; k <= n; ++k)
    {
        const double s = 10.0 * k / n;
        series.t.push_back(s + 0.5 * std::sin(s * std::acos(-1.0) / 5) * 5 / std::acos(-1.0));
        series.value.push_back(f(series.t.back()));
    }
    return series;
}

TEST(Integral, IsExactForLinesBetweenUnevenSamples)
{
    const TimeSeries series{{0, 1, 3, 4}, {0, 2, -2, 6}};
    const Integral integral(series);
    EXPECT_DOUBLE_EQ(integral.between(0, 4), 1 + 0 + 2);
    EXPECT_DOUBLE_EQ(integral.between(1, 2), 1);
    EXPECT_DOUBLE_EQ(integral.between(0.5, 1.5), 0.75 + 0.75);
    EXPECT_DOUBLE_EQ(integral.between(2, 1), -1);
    EXPECT_DOUBLE_EQ(integral.between(3, 3), 0);
    EXPECT_THROW(integral.between(-1, 1), CaseError);
    EXPECT_THROW(integral.between(1, 4.1), CaseError);
}

TEST(MovingAverage, OfAHatIsTheAreaInTheWindow)
{
    const TimeSeries even = movingAverage({{0, 1, 2}, {0, 1, 0}}, 1);
    EXPECT_DOUBLE_EQ(even.value[1], 0.75);
    const TimeSeries sloping = movingAverage({{0, 1, 3}, {0, 1, 0}}, 1);
    EXPECT_DOUBLE_EQ(sloping.value[1], 0.375 + 0.4375);
}

TEST(MovingAverage, LeavesALineAsItIsUpToTheEnds)
{
    const TimeSeries line = uneven(200, [](double t) { return 300 - 20 * t; });
    for (const double width : {0.01, 0.3, 4.0, 100.0})
    {
        const TimeSeries smooth = movingAverage(line, width);
        ASSERT_EQ(smooth.t, line.t);
        for (std::size_t k = 0; k < line.size(); ++k)
        {
            EXPECT_NEAR(smooth.value[k], line.value[k], 1e-10) << width << " at " << line.t[k];
        }
    }
}

TEST(MovingAverage, OfAParabolaAddsAsTheWindowAndTheSpacingSay)
{
    // The mean of t^2 over the window is t^2 + w^2/12; the chords lie h^2/6 above it.
    const double h = 0.125, width = 1;
    TimeSeries parabola;
    for (int k = 0; k <= 80; ++k)
    {
        parabola.t.push_back(k * h);
        parabola.value.push_back(std::pow(k * h, 2));
    }
    const TimeSeries smooth = movingAverage(parabola, width);
    for (std::size_t k = 4; k + 4 < parabola.size(); ++k)
    {
        EXPECT_NEAR(smooth.value[k], parabola.value[k] + width * width / 12 + h * h / 6, 1e-12);
    }
    // Nearer to an end the window is what fits in: here one spacing to both sides.
    EXPECT_NEAR(smooth.value[1], h * h + 4 * h * h / 12 + h * h / 6, 1e-15);
    EXPECT_EQ(smooth.value.front(), parabola.value.front());
    EXPECT_EQ(smooth.value.back(), parabola.value.back());
}

TEST(MovingAverage, DampsAnUnevenlySampledSineAsItsTransferFunctionSaysToSecondOrder)
{
    const double omega = 3, width = 0.8, damped = std::sin(omega * width / 2) / (omega * width / 2);
    const auto error = [&](int n)
    {
        const TimeSeries smooth = movingAverage(uneven(n, [&](double t) { return std::sin(omega * t); }), width);
        double largest = 0;
        for (std::size_t k = 0; k < smooth.size(); ++k)
        {
            if (smooth.t[k] > 1 && smooth.t[k] < 9)
            {
                largest = std::max(largest, std::abs(smooth.value[k] - damped * std::sin(omega * smooth.t[k])));
            }
        }
        return largest;
    };
    EXPECT_LT(error(800), 2e-4);
    EXPECT_NEAR(std::log2(error(400) / error(800)), 2, 0.1);
    EXPECT_NEAR(std::log2(error(800) / error(1600)), 2, 0.1);
}

TEST(MovingAverage, LosesNoDigitsLateInALongRecord)
{
    TimeSeries series;
    for (int k = 0; k <= 1000000; ++k)
    {
        series.t.push_back(k * 1e-3);
        series.value.push_back(1e5 + k % 2);
    }
    // Over two intervals about an even sample: 1e5, and 1 at both ends.
    EXPECT_NEAR(movingAverage(series, 2e-3).value[900000] - 1e5, 0.5, 1e-6);
}

TEST(MovingAverage, OfWidthZeroOrOfOneSampleOrNoneChangesNothing)
{
    const TimeSeries series{{0, 1, 3}, {5, -1, 2}};
    EXPECT_EQ(movingAverage(series, 0).value, series.value);
    EXPECT_EQ(movingAverage({{2}, {5}}, 1).value, std::vector<double>{5});
    EXPECT_TRUE(movingAverage({}, 1).empty());
}

TEST(MovingAverage, RefusesAWidthThatIsNegativeOrNoNumber)
{
    EXPECT_THROW(movingAverage({{0, 1}, {0, 1}}, -1), CaseError);
    EXPECT_THROW(movingAverage({{0, 1}, {0, 1}}, std::numeric_limits<double>::quiet_NaN()), CaseError);
}

} // namespace
} // namespace slosh
