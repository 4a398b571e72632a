// SPDX-License-Identifier: GPL-3.0-or-later
#include "randomParticles.hpp"

#include "base/CaseError.hpp"
#include "neighbours/CellGrid.hpp"
#include "neighbours/coincident.hpp"
#include "neighbours/sortByCell.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace slosh
{
namespace
{

TEST(CellGrid, StaysSmallWhenADropletIsFarAway)
{
    Particles particles = randomParticles(3, 1000, 0, 9);
    particles.r[17] = Vec(4e5, -3e5, 1e5);
    CellGrid grid;
    grid.build(particles.r, 0.01);
    const auto cells = grid.cells();
    EXPECT_LE(static_cast<double>(cells[0]) * cells[1] * cells[2], 64 + 4 * 1000);
    bool found = false;
    grid.forEachNear(particles.r[17], 0.01, [&](int i) { found = found || i == 17; });
    EXPECT_TRUE(found);
}

TEST(CellGrid, HoldsThePointsOfTanksAboutTheOriginWhereARoundedCornerWouldLieBeyondThem)
{
    // Sites of lattices as tanks are filled: for some of these floor(x/cell) cell is greater than x.
    int roundedUp = 0;
    for (const double length : {0.1, 0.3, 0.46, 0.92, 1.0})
    {
        for (int n = 5; n < 60; ++n)
        {
            const double dx = length / n, cell = 3 * dx;
            std::vector<Vec> points;
            for (int i = 0; i < n; ++i)
            {
                const double x = -length / 2 + (i + 0.5) * dx;
                points.emplace_back(x, x, x);
            }
            roundedUp += std::floor(points[0].x() / cell) * cell > points[0].x();
            CellGrid grid;
            grid.build(points, cell);
            for (int i = 0; i < n; ++i)
            {
                const auto c = grid.cellOf(points[i]);
                for (std::size_t d = 0; d < 3; ++d)
                {
                    ASSERT_GE(c[d], 0);
                    ASSERT_LT(c[d], grid.cells()[d]);
                }
                int near = 0;
                grid.forEachNear(
                    points[i], 1.01 * std::sqrt(3.0) * dx,
                    [&](int k) { near += (points[k] - points[i]).norm() < 1.01 * std::sqrt(3.0) * dx; }
                );
                EXPECT_EQ(near, i == 0 || i == n - 1 ? 2 : 3);
            }
        }
    }
    EXPECT_GT(roundedUp, 0);
}

TEST(CellGrid, NamesTheParticleWhosePositionIsNotANumber)
{
    Particles particles = randomParticles(2, 10, 0, 1);
    particles.r[4].z() = std::nan("");
    CellGrid grid;
    try
    {
        grid.build(particles.r, 0.1, particles.id);
        FAIL() << "accepted";
    }
    catch (const CaseError& error)
    {
        EXPECT_NE(std::string(error.what()).find("particle " + std::to_string(particles.id[4])), std::string::npos);
    }
}

TEST(SortByCell, GivesAnOrderThatDependsOnPositionsAndIdsAlone)
{
    Particles one = randomParticles(3, 800, 20, 11);
    Particles other = one;
    // The same liquid stored the other way round.
    std::reverse(other.r.begin(), other.r.begin() + 800);
    std::reverse(other.rho.begin(), other.rho.begin() + 800);
    std::reverse(other.id.begin(), other.id.begin() + 800);
    sortByCell(one, 0.2);
    sortByCell(other, 0.2);
    EXPECT_EQ(one.id, other.id);
    EXPECT_EQ(one.rho, other.rho);
    EXPECT_NE(one.id, randomParticles(3, 800, 20, 11).id);
    for (std::size_t i = 0; i < 800; ++i)
    {
        EXPECT_EQ(one.r[i], other.r[i]);
    }
}

TEST(SortByCell, OrdersParticlesAsItDoesWithoutOneThatIsFarAwayAndNotesTheirBricks)
{
    const double R = 0.15; // bricks of 1.8
    Particles one = randomParticles(3, 800, 20, 11);
    Particles other = one;
    other.id[5] = 5000; // among the others it would stand there
    other.r[5] = Vec(-0.9, -0.7, -0.3);
    one.r[5] = Vec(-2.5, -2.4, 0.1);
    sortByCell(one, R);
    sortByCell(other, R);
    const auto without = [](std::vector<int> ids, int left)
    {
        ids.resize(800);
        ids.erase(std::remove(ids.begin(), ids.end(), left), ids.end());
        return ids;
    };
    EXPECT_EQ(without(one.id, 35), without(other.id, 5000));
    ASSERT_GT(one.bricks.size(), 5);
    EXPECT_EQ(one.bricks.front(), 0);
    EXPECT_EQ(one.bricks.back(), 800);
    for (std::size_t k = 0; k + 1 < one.bricks.size(); ++k)
    {
        const auto brickOf = [&](std::ptrdiff_t i, int d) { return std::floor(one.r[i][d] / (12 * R) * (1 + 1e-12)); };
        for (std::ptrdiff_t i = one.bricks[k]; i < one.bricks[k + 1]; ++i)
        {
            EXPECT_EQ(brickOf(i, 0), brickOf(one.bricks[k], 0));
            EXPECT_EQ(brickOf(i, 1), brickOf(one.bricks[k], 1));
        }
    }
}

TEST(Coincident, FindsTwoLiquidParticlesInOnePlaceAndNothingElse)
{
    Particles particles = randomParticles(3, 800, 20, 11);
    particles.spacing = 0.1;
    EXPECT_FALSE(coincident(particles, 1e-7));
    particles.r[805] = particles.r[12]; // a wall particle does not count
    EXPECT_FALSE(coincident(particles, 1e-7));
    particles.r[611] = particles.r[12] + Vec(0, 2e-7, 0);
    EXPECT_FALSE(coincident(particles, 1e-7));
    particles.r[611] = particles.r[12] + Vec(0, 0.5e-7, 0);
    ASSERT_TRUE(coincident(particles, 1e-7));
    EXPECT_EQ(*coincident(particles, 1e-7), std::pair(std::ptrdiff_t(12), std::ptrdiff_t(611)));
}

} // namespace
} // namespace slosh
