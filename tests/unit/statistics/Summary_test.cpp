// SPDX-License-Identifier: GPL-3.0-or-later
#include "statistics/Summary.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace slosh
{
namespace
{

TEST(Summary, OfTheFirstThirtyNumbers)
{
    std::vector<double> numbers;
    for (int k = 0; k < 30; ++k)
    {
        numbers.push_back(1 + (7 * k) % 30); // in another order
    }
    const Summary summary = summarise(numbers);
    EXPECT_EQ(summary.count, 30u);
    EXPECT_DOUBLE_EQ(summary.mean, 15.5);
    EXPECT_DOUBLE_EQ(summary.standardDeviation, std::sqrt(30.0 * 31 / 12));
    EXPECT_DOUBLE_EQ(summary.standardError, std::sqrt(31.0 / 12));
    EXPECT_DOUBLE_EQ(summary.highestThird, 25.5);
    EXPECT_DOUBLE_EQ(summary.highestTenth, 29);
    EXPECT_DOUBLE_EQ(summary.maximum, 30);
}

TEST(Summary, RoundsTheNumberOfTheLargestAndTakesOneAtLeast)
{
    EXPECT_DOUBLE_EQ(summarise({1, 2, 3, 4}).highestThird, 4);      // 1.33
    EXPECT_DOUBLE_EQ(summarise({1, 2, 3, 4, 5}).highestThird, 4.5); // 1.67
    EXPECT_DOUBLE_EQ(summarise({1, 2}).highestTenth, 2);            // 0.2
}

TEST(Summary, LosesNoDigitsToALargeMean)
{
    EXPECT_DOUBLE_EQ(summarise({1e9 - 1, 1e9, 1e9 + 1}).standardDeviation, 1);
}

TEST(Summary, LeavesUndefinedWhatOneValueOrNoneCannotTell)
{
    const Summary one = summarise({5});
    EXPECT_EQ(one.mean, 5);
    EXPECT_EQ(one.highestTenth, 5);
    EXPECT_TRUE(std::isnan(one.standardDeviation) && std::isnan(one.standardError));
    const Summary none = summarise({});
    EXPECT_EQ(none.count, 0u);
    EXPECT_TRUE(std::isnan(none.mean) && std::isnan(none.maximum));
}

} // namespace
} // namespace slosh
