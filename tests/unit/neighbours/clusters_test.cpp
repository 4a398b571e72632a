// SPDX-License-Identifier: GPL-3.0-or-later
#include "randomParticles.hpp"

#include "base/CaseError.hpp"
#include "neighbours/CellGrid.hpp"
#include "neighbours/coincident.hpp"
#include "neighbours/sortByBrick.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

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

TEST(Clusters, NameTheParticleWhosePositionIsNotANumber)
{
    Particles particles = randomParticles(2, 10, 0, 1);
    particles.r[4].z() = std::nan("");
    Clusters clusters;
    try
    {
        clusters.build(particles.r, particles.id, 0.1);
        FAIL() << "accepted";
    }
    catch (const CaseError& error)
    {
        EXPECT_NE(std::string(error.what()).find("particle " + std::to_string(particles.id[4])), std::string::npos);
    }
}

TEST(Clusters, AreFullButForTheLastOfABrickAndCompact)
{
    for (const int dim : {2, 3})
    {
        const int n = 4000;
        const Particles particles = randomParticles(dim, n, 0, 7);
        Clusters clusters;
        clusters.build(particles.r, particles.id, 0.6);
        ASSERT_GT(clusters.bricks(), 5);
        std::set<int> found;
        double extents = 0;
        for (std::ptrdiff_t b = 0; b < clusters.bricks(); ++b)
        {
            for (int c = clusters.firstCluster(b); c < clusters.firstCluster(b + 1); ++c)
            {
                EXPECT_TRUE(clusters.pointsIn(c) == clusterSize || c + 1 == clusters.firstCluster(b + 1));
                BoundingBox box;
                for (int k = 0; k < clusters.pointsIn(c); ++k)
                {
                    const int i = clusters.point(clusters.firstPlace(c) + k);
                    EXPECT_TRUE(found.insert(i).second);
                    box.extend(particles.r[i]);
                    for (int d = 0; d < 3; ++d)
                    {
                        EXPECT_EQ(std::floor(particles.r[i][d] / 0.6), clusters.cell(b)[d]);
                    }
                }
                extents += box.sizes().maxCoeff();
            }
        }
        EXPECT_EQ(found.size(), n);
        // Cubes of eight points would have this edge.
        const double edge = std::pow((dim == 2 ? 2 * 0.6 : 4 * 0.6) * clusterSize / n, 1.0 / dim);
        EXPECT_LT(extents / static_cast<double>(clusters.clusters()), 1.3 * edge);
    }
}

TEST(SortByBrick, GivesAnOrderThatDependsOnPositionsAndIdsAlone)
{
    Particles one = randomParticles(3, 800, 20, 11);
    Particles other = one;
    // The same liquid stored the other way round; some of it on one plane.
    for (Particles* particles : {&one, &other})
    {
        for (std::size_t i = 0; i < 300; ++i)
        {
            particles->r[i].z() = 0.1;
        }
    }
    std::reverse(other.r.begin(), other.r.begin() + 800);
    std::reverse(other.rho.begin(), other.rho.begin() + 800);
    std::reverse(other.id.begin(), other.id.begin() + 800);
    sortByBrick(one, 0.4);
    sortByBrick(other, 0.4);
    EXPECT_EQ(one.id, other.id);
    EXPECT_EQ(one.rho, other.rho);
    EXPECT_NE(one.id, randomParticles(3, 800, 20, 11).id);
    for (std::size_t i = 0; i < 800; ++i)
    {
        EXPECT_EQ(one.r[i], other.r[i]);
    }
}

TEST(SortByBrick, OrdersABrickAsItDoesWithoutParticlesElsewhereAndNotesWhereItBegins)
{
    constexpr double edge = 0.6;
    Particles one = randomParticles(3, 800, 20, 11);
    Particles other = one;
    other.id[5] = 5000;
    other.r[5] = Vec(-0.9, -0.7, -0.25); // in a brick of others
    one.r[5] = Vec(-2.5, -2.4, 0.1);     // alone
    sortByBrick(one, edge);
    sortByBrick(other, edge);
    const auto brickOf = [&](const Vec& r, int d) { return std::floor(r[d] / edge); };
    const auto idsIn = [&](const Particles& particles, const Vec& r)
    {
        std::vector<int> ids;
        for (std::ptrdiff_t i = 0; i < particles.nFluid; ++i)
        {
            const Vec& x = particles.r[i];
            if (brickOf(x, 0) == brickOf(r, 0) && brickOf(x, 1) == brickOf(r, 1) && brickOf(x, 2) == brickOf(r, 2))
            {
                ids.push_back(particles.id[i]);
            }
        }
        return ids;
    };
    EXPECT_EQ(idsIn(one, Vec(0.9, 0.9, 0.1)), idsIn(other, Vec(0.9, 0.9, 0.1)));
    EXPECT_NE(idsIn(one, Vec(-0.9, -0.7, -0.25)), idsIn(other, Vec(-0.9, -0.7, -0.25)));
    ASSERT_GT(one.bricks.size(), 5);
    EXPECT_EQ(one.bricks.front(), 0);
    EXPECT_EQ(one.bricks.back(), 800);
    for (std::size_t k = 0; k + 1 < one.bricks.size(); ++k)
    {
        for (std::ptrdiff_t i = one.bricks[k]; i < one.bricks[k + 1]; ++i)
        {
            for (int d = 0; d < 3; ++d)
            {
                EXPECT_EQ(brickOf(one.r[i], d), brickOf(one.r[one.bricks[k]], d));
            }
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
