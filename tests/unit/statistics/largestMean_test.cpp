// SPDX-License-Identifier: GPL-3.0-or-later
#include "statistics/largestMean.hpp"

#include "base/CaseError.hpp"
#include "dictionary/Dictionary.hpp"
#include "statistics/Quantity.hpp"
#include "statistics/peaks.hpp"

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

double largest(const TimeSeries& series, double window)
{
    return largestMean(Integral(series), window);
}

/// A triangle from 0 to 1000 and back in 0.1 s and 0.3 s, after which nothing comes.
const TimeSeries triangle{{0, 1, 1.1, 1.4, 3}, {0, 0, 1000, 0, 0}};

TEST(LargestMean, OfATriangleIsWhereBothEndsOfTheWindowAreEquallyHigh)
{
    for (const double w : {1e-6, 0.001, 0.02, 0.2, 0.4})
    {
        // The ends are at the height 1000 (1 - w/0.4), and the mean is half way from there to the top.
        EXPECT_NEAR(largest(triangle, w), 1000 * (1 - w / 0.4 / 2), 1e-8) << w;
    }
    EXPECT_NEAR(largest(triangle, 0.8), 1000 * 0.4 / 2 / 0.8, 1e-9);
    EXPECT_NEAR(largest(triangle, 3), 1000 * 0.4 / 2 / 3, 1e-9);
}

TEST(LargestMean, DoesNotDependOnMoreSamplesOfTheSameLine)
{
    std::mt19937 random(1);
    std::uniform_real_distribution<double> anywhere(0, 3);
    TimeSeries finer = triangle;
    for (int k = 0; k < 500; ++k)
    {
        finer.t.push_back(anywhere(random));
    }
    std::sort(finer.t.begin(), finer.t.end());
    finer.value.clear();
    for (const double t : finer.t)
    {
        finer.value.push_back(triangle.at(t));
    }
    for (const double w : {0.001, 0.02, 0.2, 0.8})
    {
        EXPECT_NEAR(largest(finer, w), largest(triangle, w), 1e-8) << w;
    }
}

TEST(LargestMean, OfASineIsTheMeanAboutItsTopToSecondOrderOfTheSampling)
{
    const double omega = 7, w = 0.1;
    std::vector<double> errors;
    for (const int n : {40, 80})
    {
        TimeSeries sine;
        for (int k = 0; k <= 3 * n; ++k)
        {
            sine.t.push_back(2 * pi / omega * (k + 0.3) / n);
            sine.value.push_back(std::sin(omega * sine.t.back()));
        }
        errors.push_back(std::sin(omega * w / 2) / (omega * w / 2) - largest(sine, w));
    }
    EXPECT_NEAR(std::log2(errors[0] / errors[1]), 2, 0.3);
    EXPECT_NEAR(errors[1], 0, 1e-3);
}

TEST(LargestMean, IsNeverBelowThatOfAnyWindow)
{
    std::mt19937 random(2);
    std::exponential_distribution<double> gap(100);
    std::normal_distribution<double> noise;
    TimeSeries series;
    double t = 0;
    for (int k = 0; k < 300; ++k)
    {
        series.t.push_back(t += gap(random));
        series.value.push_back(noise(random));
    }
    const Integral integral(series);
    for (const double w : {0.003, 0.05, 0.5})
    {
        const double mean = largestMean(integral, w);
        double highest = -10;
        const double first = series.t.front(), last = series.t.back() - w;
        for (int k = 0; k <= 20000; ++k)
        {
            const double begin = std::min(first + (last - first) * k / 20000, last);
            highest = std::max(highest, integral.between(begin, begin + w) / w);
        }
        EXPECT_GE(mean, highest - 1e-12) << w;
        EXPECT_NEAR(mean, highest, 0.02) << w;
    }
}

TEST(LargestMean, StaysWithinTheTimesAndTheRecord)
{
    const Integral integral(triangle);
    EXPECT_NEAR(largestMean(integral, 0.1, 1.2), 1000 * 0.15 / 0.3 * 1.0, 1e-9);
    EXPECT_NEAR(largestMean(integral, 0.05, 0, 1.05), 250, 1e-9);
    EXPECT_TRUE(std::isnan(largestMean(integral, 3.01)));
    EXPECT_TRUE(std::isnan(largestMean(integral, 0.1, 1, 1.09)));
    EXPECT_TRUE(std::isnan(largestMean(integral, 0.1, 2.95)));
    const TimeSeries shortOne{{1.0, 1.01, 1.02}, {1, 2, 3}};
    EXPECT_NEAR(largest(shortOne, 0.02), 2, 1e-12) << "as long as the record, to rounding";
    EXPECT_THROW(largestMean(integral, 0), CaseError);
    EXPECT_THROW(largestMean(integral, -1), CaseError);
}

TEST(LargestMean, AroundPeaksHoldsEach)
{
    // Two triangles of 500 and 1000, their tops 0.5 s apart.
    const TimeSeries two{{0, 1, 1.1, 1.2, 1.5, 1.6, 1.7, 3}, {0, 0, 500, 0, 0, 1000, 0, 0}};
    const auto peaks = findPeaks(two, 100, 0);
    ASSERT_EQ(peaks.size(), 2u);
    const auto apart = largestMeansAround(peaks, two, 0.02);
    EXPECT_NEAR(apart.at(0), 500 * 0.95, 1e-9);
    EXPECT_NEAR(apart.at(1), 1000 * 0.95, 1e-9);
    const auto shared = largestMeansAround(peaks, two, 0.8);
    EXPECT_NEAR(shared.at(0), 150 / 0.8, 1e-9);
    EXPECT_NEAR(shared.at(1), 150 / 0.8, 1e-9);
    EXPECT_TRUE(std::isnan(largestMeansAround(peaks, two, 4).at(0)));
}

TEST(LargestMean, IsAQuantity)
{
    const Dictionary dict = Dictionary::parse("quantity largestMean; window 0.02;", "system/comparisonsDict");
    EXPECT_NEAR(readQuantity(dict)(triangle).value, 1000 * 0.975, 1e-9);
    EXPECT_THROW(readQuantity(dict)({{0, 0.01}, {1, 1}}), CaseError);
    EXPECT_THROW(readQuantity(dict)({}), CaseError);
    EXPECT_THROW(readQuantity(Dictionary::parse("quantity largestMean; window 0;", "x")), CaseError);
    EXPECT_THROW(readQuantity(Dictionary::parse("quantity largestMean;", "x")), CaseError);
}

} // namespace
} // namespace slosh
