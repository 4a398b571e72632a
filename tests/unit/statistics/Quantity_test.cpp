// SPDX-License-Identifier: GPL-3.0-or-later
#include "statistics/Quantity.hpp"

#include "base/CaseError.hpp"
#include "dictionary/Dictionary.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace slosh
{
namespace
{

Estimate figureOf(const std::string& quantity, const TimeSeries& series)
{
    return readQuantity(Dictionary::parse(quantity, "system/comparisonsDict"))(series);
}

/// f at uneven times in [begin, end].
template <class F>
TimeSeries sampled(double begin, double end, int n, const F& f)
{
    TimeSeries series;
    for (int k = 0; k <= n; ++k)
    {
        const double part = static_cast<double>(k) / n;
        series.t.push_back(begin + (end - begin) * (part + 0.1 / n * std::sin(37.0 * k) * (k > 0 && k < n)));
        series.value.push_back(f(series.t.back()));
    }
    return series;
}

const double pi = std::acos(-1.0);

TEST(Quantities, OfALineAreExactWhateverItsSampling)
{
    const TimeSeries line = sampled(1, 3, 17, [](double t) { return 2 * t - 1; });
    EXPECT_NEAR(figureOf("quantity mean;", line).value, 3, 1e-13);
    EXPECT_NEAR(figureOf("quantity maximum;", line).value, 5, 1e-13);
    EXPECT_NEAR(figureOf("quantity minimum;", line).value, 1, 1e-13);
    EXPECT_NEAR(figureOf("quantity range;", line).value, 4, 1e-13);
    EXPECT_NEAR(figureOf("quantity timeOfMaximum;", line).value, 3, 1e-13);
    EXPECT_NEAR(figureOf("quantity value; time 1.234;", line).value, 1.468, 1e-13);
    EXPECT_NEAR(figureOf("quantity integral;", line).value, 6, 1e-13);
    EXPECT_NEAR(figureOf("quantity firstTimeAbove; level 2.5;", line).value, 1.75, 1e-13);
    EXPECT_EQ(figureOf("quantity firstTimeAbove; level 0.5;", line).value, 1) << "above from the first sample on";
    EXPECT_TRUE(std::isnan(figureOf("quantity firstTimeAbove; level 5;", line).value)) << "never above";
    EXPECT_TRUE(std::isnan(figureOf("quantity impulse; level 5; before 0.1; after 0.1;", line).value));
    EXPECT_THROW(figureOf("quantity firstTimeAbove; level 5;", TimeSeries()), CaseError);
    EXPECT_NEAR(integral(line, 1.5, 2.5), 3, 1e-13);
    EXPECT_NEAR(integral(line, 2.5, 9), 0.5 * (4 + 5) / 2, 1e-13);
    EXPECT_EQ(integral(line, 5, 9), 0);
}

TEST(Quantities, RmsOfASineIsItsAmplitudeOverRootTwo)
{
    const TimeSeries sine = sampled(0, 4, 4000, [](double t) { return 7 + 3 * std::sin(2 * pi * t); });
    EXPECT_NEAR(figureOf("quantity rms;", sine).value, 3 / std::sqrt(2.0), 1e-5);
}

TEST(Quantities, MeanPeakCountsWholePeriodsAndHasAStandardError)
{
    // Peaks 1, 2, 3, and half a period that would be the highest.
    const TimeSeries peaks =
        sampled(10, 13.5, 7000, [](double t) { return (std::floor(t) - 9) * std::pow(std::sin(pi * (t - 10)), 2); });
    const Estimate estimate = figureOf("quantity meanPeak; period 1;", peaks);
    EXPECT_NEAR(estimate.value, 2, 1e-5);
    EXPECT_NEAR(estimate.uncertainty, 1 / std::sqrt(3.0), 1e-5); // standard deviation 1, three periods
    EXPECT_EQ(estimate.count, 3u);
    EXPECT_THROW(figureOf("quantity meanPeak; period 4;", peaks), CaseError);
}

TEST(Quantities, ImpulseIsTakenAroundTheHighestValueOrFromTheRise)
{
    const TimeSeries triangle{{0, 1, 1.1, 1.3, 2}, {0, 0, 10, 0, 0}};
    EXPECT_NEAR(figureOf("quantity impulse; before 0.1; after 0.2;", triangle).value, 1.5, 1e-12);
    EXPECT_NEAR(figureOf("quantity impulse; before 0.05; after 0;", triangle).value, 0.375, 1e-12);
    EXPECT_NEAR(figureOf("quantity impulse; level 5; before 0; after 0.05;", triangle).value, 0.375, 1e-12);
}

TEST(Differences, AreZeroForTheReferenceItselfAndOneForItsMean)
{
    const TimeSeries sine = sampled(0, 2, 500, [](double t) { return 5 + std::sin(2 * pi * t); });
    const TimeSeries shifted = sampled(0, 2, 500, [](double t) { return 5 + std::sin(2 * pi * (t - 0.05)); });
    EXPECT_NEAR(relativeDifference(sine, sine), 0, 1e-14);
    EXPECT_NEAR(relativeDifference({{0, 0.25, 1, 1.75}, {5, 5, 5, 5}}, {{0, 0.3, 0.4, 2}, {4, 4, 6, 6}}), 1, 1e-12);
    EXPECT_NEAR(relativeDifference(shifted, sine), 2 * std::sin(pi * 0.05), 2e-3); // |e^(i phi) - 1|
    EXPECT_THROW(relativeDifference(sine, {{3, 4}, {1, 2}}), CaseError);
    EXPECT_THROW(relativeDifference(sine, {{0, 4}, {1, 1}}), CaseError);
}

TEST(Differences, ShareInsideCountsTheSamplesInTheBand)
{
    const TimeSeries series{{0, 1, 2, 3, 9}, {0, 1, 2, 3, 0}};
    EXPECT_DOUBLE_EQ(shareInside(series, {{0, 4}, {0.5, 0.5}}, {{0, 4}, {2, 2}}), 0.5);
}

TEST(Quantities, ThatAreUnknownAreNamedWithTheNearest)
{
    try
    {
        figureOf("quantity meanPeek;", {});
        FAIL();
    }
    catch (const CaseError& error)
    {
        EXPECT_NE(std::string(error.what()).find("did you mean 'meanPeak'"), std::string::npos) << error.what();
    }
    EXPECT_THROW(figureOf("quantity maximum;", {}), CaseError);
}

} // namespace
} // namespace slosh
