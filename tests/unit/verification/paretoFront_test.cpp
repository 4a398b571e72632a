// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/paretoFront.hpp"

#include "base/CaseError.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace slosh
{
namespace
{

using Indices = std::vector<std::size_t>;

TEST(ParetoFront, HoldsWhatNothingBeatsByRisingCost)
{
    EXPECT_EQ(paretoFront({4, 1, 2, 3}, {0.1, 0.5, 0.3, 0.4}), (Indices{1, 2, 0}));
    EXPECT_EQ(paretoFront({1, 1, 2}, {0.5, 0.4, 0.4}), (Indices{1})) << "as exact for more is beaten";
    EXPECT_EQ(paretoFront({1, 1}, {0.5, 0.5}), (Indices{0})) << "of equals the first";
    EXPECT_EQ(paretoFront({}, {}), Indices{});
}

TEST(ParetoFront, LeavesOutWhatIsNoNumber)
{
    EXPECT_EQ(paretoFront({1, std::nan(""), 3, 4}, {std::nan(""), 0.1, 0.3, INFINITY}), (Indices{2}));
}

TEST(ParetoFront, IsThatOfItsDefinition)
{
    std::mt19937_64 random(3);
    std::vector<double> cost, error;
    for (int i = 0; i < 300; ++i)
    {
        cost.push_back(static_cast<double>(random() % 40));
        error.push_back(static_cast<double>(random() % 40));
    }
    const Indices front = paretoFront(cost, error);
    std::vector<bool> isOnFront(cost.size(), false);
    for (const std::size_t i : front)
    {
        isOnFront[i] = true;
    }
    for (std::size_t i = 0; i < cost.size(); ++i)
    {
        bool beaten = false, equalBefore = false;
        for (std::size_t j = 0; j < cost.size(); ++j)
        {
            const bool equal = cost[j] == cost[i] && error[j] == error[i];
            beaten = beaten || (cost[j] <= cost[i] && error[j] <= error[i] && !equal);
            equalBefore = equalBefore || (equal && j < i);
        }
        EXPECT_EQ(isOnFront[i], !beaten && !equalBefore) << i;
    }
}

TEST(ParetoFront, NeedsAnErrorForEachCost)
{
    EXPECT_THROW(paretoFront({1, 2}, {1}), CaseError);
}

} // namespace
} // namespace slosh
