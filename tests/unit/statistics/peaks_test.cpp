// SPDX-License-Identifier: GPL-3.0-or-later
#include "statistics/peaks.hpp"

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

std::vector<double> timesOf(const std::vector<Peak>& peaks)
{
    std::vector<double> times;
    for (const Peak& peak : peaks)
    {
        times.push_back(peak.time);
    }
    return times;
}

TEST(Peaks, OfATriangleAreItsSidesAndThreeQuartersOfItsArea)
{
    const auto peaks = findPeaks({{0, 1, 1.3, 2, 5}, {0, 0, 1000, 0, 0}}, 500, 0);
    ASSERT_EQ(peaks.size(), 1u);
    EXPECT_EQ(peaks[0].time, 1.3);
    EXPECT_EQ(peaks[0].value, 1000);
    EXPECT_NEAR(peaks[0].riseTime, 0.3, 1e-14);
    EXPECT_NEAR(peaks[0].decayTime, 0.7, 1e-14);
    EXPECT_NEAR(peaks[0].impulse, 0.75 * 1000 * (0.3 + 0.7) / 2, 1e-11);
}

TEST(Peaks, OfATriangleDoNotDependOnWhereItsSidesAreSampled)
{
    // On the sides: 600 at 1.18, 200 at 1.06; 900 at 1.37, 400 at 1.72.
    const auto peaks = findPeaks({{0, 1, 1.06, 1.18, 1.3, 1.37, 1.72, 2}, {0, 0, 200, 600, 1000, 900, 400, 0}}, 0, 0);
    ASSERT_EQ(peaks.size(), 1u);
    EXPECT_NEAR(peaks[0].riseTime, 0.3, 1e-14);
    EXPECT_NEAR(peaks[0].decayTime, 0.7, 1e-14);
    EXPECT_NEAR(peaks[0].impulse, 375, 1e-11);
}

constexpr double omega = 7;

/// Ten periods of 800 sin(omega t), n uneven samples to each, at the phases s + f(s).
template <class F>
TimeSeries sine(int n, F f)
{
    TimeSeries series;
    for (int k = 0; k <= 10 * n; ++k)
    {
        const double s = 2 * pi * k / n;
        series.t.push_back((s + f(s)) / omega);
        series.value.push_back(800 * std::sin(s + f(s)));
    }
    return series;
}

TEST(Peaks, OfAnUnevenlySampledSineHaveItsTimesWithinTheErrorOfInterpolation)
{
    // Half the crest is at a phase of pi/6: rise = decay = 2 (pi/2 - pi/6)/omega. There a chord over a phase d errs by
    // d^2/8 sin(pi/6) at most, the phase by that over cos(pi/6).
    for (const int n : {48, 400, 3200})
    {
        const auto peaks = findPeaks(sine(n, [](double s) { return 0.5 * std::cos(s); }), 700, 0.5);
        const double d = 1.5 * 2 * pi / n, bound = 1.2 * 2 * d * d / 8 * std::tan(pi / 6) / omega;
        ASSERT_EQ(peaks.size(), 10u);
        for (std::size_t k = 0; k < peaks.size(); ++k)
        {
            EXPECT_NEAR(peaks[k].time, (pi / 2 + 2 * pi * static_cast<double>(k)) / omega, 1e-12);
            EXPECT_NEAR(peaks[k].value, 800, 1e-9);
            EXPECT_NEAR(peaks[k].riseTime, 2 * pi / 3 / omega, bound) << n;
            EXPECT_NEAR(peaks[k].decayTime, 2 * pi / 3 / omega, bound) << n;
        }
    }
}

TEST(Peaks, OfAnUnevenlySampledSineHaveItsImpulseToSecondOrder)
{
    // 2 A cos(pi/6)/omega; crests and half values are among the samples.
    const auto error = [](int n)
    {
        const auto peaks = findPeaks(sine(n, [](double s) { return 0.1 * std::sin(6 * s); }), 700, 0.5);
        EXPECT_EQ(peaks.size(), 10u);
        return std::abs(peaks[3].impulse / (800 * std::sqrt(3.0) / omega) - 1);
    };
    EXPECT_LT(error(240), 1e-4);
    EXPECT_NEAR(std::log2(error(240) / error(480)), 2, 0.02);
    EXPECT_NEAR(std::log2(error(480) / error(960)), 2, 0.02);
}

TEST(Peaks, NearerThanTheSeparationGiveWayToTheLargest)
{
    TimeSeries series;
    const double crests[] = {5, 7, 6, 9, 4, 4};
    for (int k = 0; k < 6; ++k)
    {
        series.t.insert(series.t.end(), {double(k), k + 0.5});
        series.value.insert(series.value.end(), {0, crests[k]});
    }
    series.t.push_back(6);
    series.value.push_back(0);
    EXPECT_EQ(timesOf(findPeaks(series, 0, 0)), (std::vector<double>{0.5, 1.5, 2.5, 3.5, 4.5, 5.5}));
    EXPECT_EQ(timesOf(findPeaks(series, 0, 1)), (std::vector<double>{0.5, 1.5, 2.5, 3.5, 4.5, 5.5}));
    // 9 removes 6 and the 4 beside it; 7 is no longer beside a larger one; the last 4 is alone.
    EXPECT_EQ(timesOf(findPeaks(series, 0, 1.5)), (std::vector<double>{1.5, 3.5, 5.5}));
    EXPECT_EQ(timesOf(findPeaks(series, 0, 2.5)), (std::vector<double>{0.5, 3.5}));
    EXPECT_EQ(timesOf(findPeaks(series, 0, 100)), (std::vector<double>{3.5}));
    // Of equals the earlier.
    EXPECT_EQ(timesOf(findPeaks(series.between(3.9, 6), 0, 1.5)), (std::vector<double>{4.5}));
}

TEST(Peaks, AreAsFarApartAsAskedAndLeaveOutOnlyWhatIsNearToALargerOne)
{
    std::mt19937_64 random(1);
    for (int run = 0; run < 50; ++run)
    {
        TimeSeries series;
        double t = 0;
        for (int k = 0; k < 500; ++k)
        {
            t += 0.01 + static_cast<double>(random() % 100) * 1e-3;
            series.t.push_back(t);
            series.value.push_back(static_cast<double>(random() % 50)); // many equals
        }
        const double separation = 0.1 * (1 + run % 10);
        const auto all = findPeaks(series, 20, 0), kept = findPeaks(series, 20, separation);
        ASSERT_GT(all.size(), kept.size());
        for (std::size_t k = 0; k < kept.size(); ++k)
        {
            EXPECT_GT(kept[k].value, 20);
            EXPECT_TRUE(k == 0 || kept[k].time - kept[k - 1].time >= separation);
        }
        for (const Peak& peak : all)
        {
            EXPECT_TRUE(std::any_of(
                kept.begin(), kept.end(),
                [&](const Peak& other) {
                    return other.time == peak.time ||
                           (std::abs(other.time - peak.time) < separation && other.value >= peak.value);
                }
            )) << peak.time;
        }
    }
}

TEST(Peaks, AreAboveTheThresholdNotAtIt)
{
    const TimeSeries series{{0, 1, 2, 3, 4}, {0, 500, 0, 501, 0}};
    EXPECT_EQ(timesOf(findPeaks(series, 500, 0)), std::vector<double>{3});
    EXPECT_TRUE(findPeaks(series, 501, 0).empty());
    EXPECT_TRUE(findPeaks({}, 0, 0).empty());
}

TEST(Peaks, WithAFlatTopCountOnceAndShouldersNot)
{
    const auto peaks = findPeaks({{0, 1, 2, 3, 4, 5}, {0, 3, 3, 4, 4, 0}}, 0, 0);
    ASSERT_EQ(peaks.size(), 1u);
    EXPECT_EQ(peaks[0].time, 3);
    EXPECT_NEAR(peaks[0].riseTime, 2 * (3 - 2.0 / 3), 1e-14);
    EXPECT_NEAR(peaks[0].decayTime, 2 * 1.5, 1e-14);
}

TEST(Peaks, AreNotAtTheEndsOfTheRecord)
{
    EXPECT_TRUE(findPeaks({{0, 1, 2}, {9, 0, 9}}, 1, 0).empty());
    EXPECT_TRUE(findPeaks({{0, 1, 2}, {0, 9, 9}}, 1, 0).empty());
}

TEST(Peaks, BetweenTwoTimesAreMeasuredOnAllOfTheSeriesAndNotThinnedByThoseOutside)
{
    const TimeSeries series{{0, 2, 4, 6, 8}, {0, 9, 0, 10, 0}};
    const auto peaks = findPeaks(series, 0, 5, 1.5, 5);
    ASSERT_EQ(timesOf(peaks), std::vector<double>{2});
    EXPECT_DOUBLE_EQ(peaks[0].riseTime, 2);
    EXPECT_EQ(timesOf(findPeaks(series, 0, 0, 2, 6)), (std::vector<double>{2, 6}));
    EXPECT_TRUE(findPeaks(series, 0, 0, 2.5, 5.5).empty());
}

TEST(Peaks, ThatDoNotFallToHalfBeforeALargerOneOrTheEndHaveNoSuchTime)
{
    const auto peaks = findPeaks({{0, 1, 2, 3, 4, 5, 6}, {9, 6, 8, 6, 20, 0, 0}}, 1, 0);
    ASSERT_EQ(peaks.size(), 2u);
    EXPECT_TRUE(std::isnan(peaks[0].riseTime) && std::isnan(peaks[0].decayTime) && std::isnan(peaks[0].impulse));
    EXPECT_NEAR(peaks[1].riseTime, 2 * 10.0 / 14, 1e-14);
    const auto last = findPeaks({{0, 1, 2}, {0, 10, 6}}, 1, 0);
    ASSERT_EQ(last.size(), 1u);
    EXPECT_NEAR(last[0].riseTime, 1, 1e-14);
    EXPECT_TRUE(std::isnan(last[0].decayTime) && std::isnan(last[0].impulse));
}

TEST(Peaks, RefuseANegativeThresholdOrSeparation)
{
    EXPECT_THROW(findPeaks({}, -1, 0), CaseError);
    EXPECT_THROW(findPeaks({}, 0, -1), CaseError);
    EXPECT_THROW(findPeaks({}, std::nan(""), 0), CaseError);
}

} // namespace
} // namespace slosh
