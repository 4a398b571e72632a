// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/gridConvergence.hpp"

#include "base/CaseError.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace slosh
{
namespace
{

/// f = 3 + C dx^p on three grids whose ratios differ, as those of particles that fit a tank do.
struct Grids
{
    std::array<double, 3> dx{2, 3.1, 4.3};
    std::array<double, 3> f{};

    Grids(double C, double p)
    {
        for (std::size_t i = 0; i < 3; ++i)
        {
            f[i] = 3 + C * std::pow(dx[i], p);
        }
    }
    std::optional<double> order() const { return orderOfThreeGrids(dx, f[1] - f[0], f[2] - f[1]); }
};

TEST(GridConvergence, FindsTheOrderAndTheLimitOfAnyPowerAndRatio)
{
    for (const double p : {0.1, 1.0, 1.37, 2.0, 6.0})
    {
        for (const double C : {-0.5, 2.0})
        {
            const Grids grids(C, p);
            const auto order = grids.order();
            ASSERT_TRUE(order.has_value()) << p;
            EXPECT_NEAR(*order, p, 1e-12);
            const double r = grids.dx[1] / grids.dx[0];
            EXPECT_NEAR(extrapolated(grids.f[0], grids.f[1], r, p), 3, 1e-11);
            // With a safety factor of 1 the index is the error itself.
            EXPECT_NEAR(gridConvergenceIndex(grids.f[1] - grids.f[0], r, p, 1), std::abs(grids.f[0] - 3), 1e-11);
        }
    }
}

// Roache's own example of a second-order method on grids doubled: f = 0.97050, 0.96854, 0.96178: p = 1.786,
// f0 = 0.97130, GCI of the finest 0.103 %. NPARC Alliance, Examining Spatial (Grid) Convergence.
TEST(GridConvergence, ReproducesAPublishedExample)
{
    const double f1 = 0.97050, f2 = 0.96854, f3 = 0.96178;
    const auto order = orderOfThreeGrids({1, 2, 4}, f2 - f1, f3 - f2);
    ASSERT_TRUE(order.has_value());
    EXPECT_NEAR(*order, 1.786170, 1e-6);
    EXPECT_NEAR(extrapolated(f1, f2, 2, *order), 0.971300, 5e-7);
    EXPECT_NEAR(gridConvergenceIndex((f2 - f1) / f1, 2, *order, safetyOfThreeGrids), 0.00103083, 5e-8);
}

TEST(GridConvergence, HasNoOrderWhereTheFigureOscillatesDivergesOrStands)
{
    EXPECT_FALSE(orderOfThreeGrids({1, 2, 4}, 0.1, -0.2)) << "oscillates";
    EXPECT_FALSE(orderOfThreeGrids({1, 2, 4}, 0.2, 0.1)) << "diverges";
    EXPECT_FALSE(orderOfThreeGrids({1, 2, 4}, 0.1, 0.1)) << "grows as a logarithm: order 0";
    EXPECT_TRUE(orderOfThreeGrids({1, 2, 4}, 0.1, 0.1001));
    EXPECT_FALSE(orderOfThreeGrids({1, 2, 4}, 0, 0.1)) << "no longer changes";
    EXPECT_FALSE(orderOfThreeGrids({1, 2, 4}, std::nan(""), 0.1));
    EXPECT_THROW(orderOfThreeGrids({2, 1, 4}, 0.1, 0.2), CaseError);
    EXPECT_THROW(orderOfThreeGrids({1, 1, 4}, 0.1, 0.2), CaseError);
}

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
