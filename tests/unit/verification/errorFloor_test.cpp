// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/errorFloor.hpp"

#include <gtest/gtest.h>

namespace slosh
{
namespace
{

TEST(ErrorFloor, IsWhereTwoRefinementsEachGainLessThanATenth)
{
    EXPECT_EQ(errorFloor({0.2, 0.1, 0.095, 0.091}), std::optional<std::size_t>(1));
    EXPECT_EQ(errorFloor({0.2, 0.19, 0.18, 0.09}), std::optional<std::size_t>(0));
    EXPECT_EQ(errorFloor({0.2, 0.1, 0.095, 0.08}), std::nullopt) << "one is not enough";
    EXPECT_EQ(errorFloor({0.2, 0.18, 0.162}), std::nullopt) << "a tenth is falling";
    EXPECT_EQ(errorFloor({0.1, 0.2, 0.3}), std::optional<std::size_t>(0));
    EXPECT_EQ(errorFloor({0.2, 0.19}), std::nullopt);
    EXPECT_EQ(errorFloor({}), std::nullopt);
}

} // namespace
} // namespace slosh
