// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/CaseError.hpp"
#include "neighbours/CellGrid.hpp"
#include "neighbours/NeighbourList.hpp"
#include "neighbours/VerletSkin.hpp"
#include "neighbours/coincident.hpp"
#include "neighbours/sortByCell.hpp"

#include <gtest/gtest.h>

#include <map>
#include <omp.h>
#include <random>
#include <set>

namespace slosh
{
namespace
{

Particles randomParticles(int dim, int fluid, int wall, unsigned seed)
{
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> x(-1, 1);
    Particles particles;
    particles.resize(fluid, wall);
    for (int i = 0; i < fluid + wall; ++i)
    {
        const auto k = static_cast<std::size_t>(i);
        particles.r[k] = Vec(x(random), dim == 3 ? x(random) : 0.25, 0.3 * x(random));
        particles.rho[k] = 1000 + i;
        particles.id[k] = i < fluid ? (7 * i) % fluid : i - fluid;
    }
    return particles;
}

/// The records of a row, those that pad it included.
std::vector<std::ptrdiff_t> recordsOf(const NeighbourRows::Row& row, int lanes)
{
    std::vector<std::ptrdiff_t> records;
    for (std::ptrdiff_t k = 0; k < row.groups * neighboursAGroup(lanes); ++k)
    {
        records.push_back(row.first[k / neighboursAGroup(lanes)] + std::ptrdiff_t(row.offset[k]));
    }
    return records;
}

std::multiset<int> rowOf(const NeighbourList& list, const Particles& particles, std::ptrdiff_t i, int lanes)
{
    std::map<std::ptrdiff_t, int> particleOf;
    for (int k = 0; k < particles.size(); ++k)
    {
        particleOf[recordOf(k)] = k;
    }
    std::multiset<int> row;
    for (const std::ptrdiff_t record : recordsOf(list.row(i), lanes))
    {
        if (const auto found = particleOf.find(record); found != particleOf.end())
        {
            row.insert(found->second);
        }
    }
    return row;
}

void expectThePairsOfASearchOverAll(const Particles& particles, double reach)
{
    NeighbourList list;
    list.build(particles, reach, 8);
    std::set<int> wallsInReach;
    for (std::ptrdiff_t i = 0; i < particles.size(); ++i)
    {
        std::multiset<int> expected;
        for (std::ptrdiff_t j = 0; j < particles.size(); ++j)
        {
            const bool bothWall = i >= particles.nFluid && j >= particles.nFluid;
            const double distance = (particles.r[i] - particles.r[j]).norm();
            if (i != j && !bothWall && distance < reach)
            {
                expected.insert(static_cast<int>(j));
            }
        }
        EXPECT_EQ(rowOf(list, particles, i, 8), expected) << "particle " << i;
        if (i >= particles.nFluid && !expected.empty())
        {
            wallsInReach.insert(static_cast<int>(i));
        }
    }
    EXPECT_EQ(std::set<int>(list.wallsInReach().begin(), list.wallsInReach().end()), wallsInReach);
}

TEST(NeighbourList, HoldsExactlyThePairsThatASearchOverAllPairsFinds)
{
    expectThePairsOfASearchOverAll(randomParticles(2, 500, 301, 3), 0.21);
    expectThePairsOfASearchOverAll(randomParticles(3, 500, 301, 3), 0.21);
}

TEST(NeighbourList, HoldsThePairsOfTanksOfAnyShapeAndOfSprayFarAway)
{
    // A canal, a chimney, a film, in 3D; of the same volume, so that there are as many neighbours.
    for (const Vec& stretch : {Vec(400, 0.05, 0.05), Vec(0.05, 0.05, 400), Vec(30, 30, 1.0 / 900)})
    {
        Particles particles = randomParticles(3, 500, 301, 3);
        for (Vec& r : particles.r)
        {
            r = r.cwiseProduct(stretch);
        }
        particles.r[17] = 50 * stretch;
        particles.r[18] = particles.r[17] + Vec(0.1, 0.1, 0.1);
        SCOPED_TRACE(testing::Message() << stretch.transpose());
        expectThePairsOfASearchOverAll(particles, 0.21);
    }
}

TEST(NeighbourList, HoldsThePairsOfMoreParticlesThanTwoBytesCount)
{
    // Long and flat, sorted along its height: neighbours stand far from each other in memory.
    Particles particles = randomParticles(2, 150000, 70000, 4);
    for (Vec& r : particles.r)
    {
        r[0] *= 100;
    }
    constexpr double reach = 0.11;
    NeighbourList list;
    list.build(particles, reach, 16);
    std::size_t groups = 0, pairs = 0;
    for (const std::ptrdiff_t i : {0, 1, 32767, 32768, 65535, 65536, 100000, 149999, 150000, 200000, 219999})
    {
        std::multiset<int> expected;
        for (std::ptrdiff_t j = 0; j < (i < particles.nFluid ? particles.size() : particles.nFluid); ++j)
        {
            const Vec apart = particles.r[i] - particles.r[j];
            if (i != j && apart.norm() < reach)
            {
                expected.insert(static_cast<int>(j));
            }
        }
        EXPECT_EQ(rowOf(list, particles, i, 16), expected) << "particle " << i;
        pairs += expected.size();
        groups += static_cast<std::size_t>(list.row(i).groups);
        for (const std::ptrdiff_t record : recordsOf(list.row(i), 16))
        {
            EXPECT_LE(record, recordOf(particles.size()));
        }
    }
    EXPECT_GT(pairs, 100);
    EXPECT_LT(groups, pairs); // random indices: groups are short here
}

TEST(NeighbourList, IsTheSameAtAnyNumberOfThreads)
{
    const Particles particles = randomParticles(3, 3000, 1000, 5);
    const int before = omp_get_max_threads();
    std::vector<std::vector<std::ptrdiff_t>> lists;
    for (const int threads : {1, 2, 4})
    {
        omp_set_num_threads(threads);
        NeighbourList list;
        list.build(particles, 0.2, 4);
        lists.emplace_back();
        for (std::ptrdiff_t i = 0; i < particles.size(); ++i)
        {
            const auto row = recordsOf(list.row(i), 4);
            lists.back().insert(lists.back().end(), row.begin(), row.end());
        }
    }
    omp_set_num_threads(before);
    EXPECT_EQ(lists[0], lists[1]);
    EXPECT_EQ(lists[0], lists[2]);
}

TEST(NeighbourList, HoldsNoPairThatDoesNotSeeEachOtherAndEveryOther)
{
    // A plate at x = 0; the records of 40,000 particles have padding in between.
    const Particles particles = randomParticles(2, 40000, 2000, 8);
    const double reach = 0.02;
    const std::vector<double> skins(particles.r.size(), 0.0);
    NeighbourList all, seen;
    all.build(particles, reach, skins, 8);
    seen.build(particles, reach, skins, 8,
               [&](std::ptrdiff_t a, std::ptrdiff_t b) { return particles.r[a].x() * particles.r[b].x() > 0; });
    long hidden = 0;
    for (std::ptrdiff_t i = 0; i < particles.size(); ++i)
    {
        std::vector<std::ptrdiff_t> expected;
        for (const std::ptrdiff_t record : recordsOf(all.row(i), 8))
        {
            const std::ptrdiff_t b = particleOf(record);
            const bool isPadding = recordOf(b) != record || b >= particles.size();
            if (!isPadding && particles.r[i].x() * particles.r[b].x() > 0)
            {
                expected.push_back(record);
            }
            hidden += !isPadding && particles.r[i].x() * particles.r[b].x() <= 0;
        }
        std::vector<std::ptrdiff_t> found;
        for (const std::ptrdiff_t record : recordsOf(seen.row(i), 8))
        {
            const std::ptrdiff_t b = particleOf(record);
            if (recordOf(b) == record && b < particles.size())
            {
                found.push_back(record);
            }
        }
        ASSERT_EQ(found, expected) << i;
    }
    EXPECT_GT(hidden, 100);
}

TEST(NeighbourList, KnowsTheGroupsOfARowThatHoldWalls)
{
    const Particles particles = randomParticles(2, 900, 300, 12);
    NeighbourList list;
    list.build(particles, 0.2, 8);
    for (std::ptrdiff_t i = 0; i < particles.nFluid; ++i)
    {
        const auto wallsIn = [&](const NeighbourRows::Row& row)
        {
            const auto records = recordsOf(row, 8);
            return std::count_if(records.begin(), records.end(),
                                 [&](std::ptrdiff_t record) {
                                     return particleOf(record) >= particles.nFluid &&
                                            particleOf(record) < particles.size();
                                 });
        };
        const NeighbourRows::Row row = list.row(i), walls = list.wallPart(i);
        EXPECT_EQ(wallsIn(walls), wallsIn(row));
        EXPECT_LE(walls.groups, wallsIn(row) / 8 + 2);
        EXPECT_EQ(walls.groups == 0, wallsIn(row) == 0);
    }
}

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

/// The skin holds at least the step it is chosen for, and of the model's costs, rows of (1 + s/R)^2 and a rebuild
/// of 2.4 sums every s/closing steps, its own is within 5 % of the least.
TEST(VerletSkin, OfLeastCostHoldsAStepAndIsWorthTheLongerRows)
{
    constexpr double R = 0.04;
    for (const double closing : {1e-5 * R, 1e-3 * R, 0.01 * R, 0.1 * R, 0.3 * R})
    {
        const double skin = VerletSkin::cheapest(R, closing);
        EXPECT_GE(skin, closing);
        EXPECT_GE(skin, 0.02 * R);
        EXPECT_LE(skin, 0.3 * R);
        if (skin > 0.021 * R && skin < 0.29 * R)
        {
            const auto cost = [&](double s) { return std::pow(1 + s / R, 2) + 2.4 * closing / s; };
            double least = cost(skin);
            for (double s = 0.02 * R; s < 0.3 * R; s *= 1.02)
            {
                least = std::min(least, cost(s));
            }
            EXPECT_LT(cost(skin), 1.05 * least);
            EXPECT_GT(cost(3 * skin), 1.05 * least);
        }
    }
}

double largestSpeed(const Particles& particles)
{
    double largest = 0;
    for (std::ptrdiff_t i = 0; i < particles.nFluid; ++i)
    {
        largest = std::max(largest, particles.v[i].norm());
    }
    return largest;
}

TEST(VerletSkin, ListsHoldEveryPairWithinTheSupportUntilTheyAreToBeRebuilt)
{
    constexpr double R = 0.2, dt = 1e-3;
    for (const bool wallsMove : {false, true})
    {
        Particles particles = randomParticles(2, 400, 100, 6);
        std::mt19937 random(2);
        std::uniform_real_distribution<double> x(-1, 1);
        for (std::ptrdiff_t i = 0; i < (wallsMove ? particles.size() : particles.nFluid); ++i)
        {
            // One in twenty is ten times as fast.
            particles.v[i] = (i % 20 == 0 ? 5.0 : 0.5) * Vec(x(random), 0, x(random));
        }
        VerletSkin skin;
        EXPECT_TRUE(skin.mustRebuild(particles, dt, largestSpeed(particles)));
        sortByCell(particles, R);
        skin.choose(particles, wallsMove, R, dt);
        NeighbourList list;
        list.build(particles, R, skin.skins(), 8);
        skin.listBuilt(particles);
        int steps = 0;
        for (; !skin.mustRebuild(particles, dt, largestSpeed(particles)); ++steps)
        {
            for (std::size_t i = 0; i < particles.r.size(); ++i)
            {
                particles.r[i] += dt * particles.v[i];
            }
            for (std::ptrdiff_t i = 0; i < particles.nFluid; ++i)
            {
                const auto row = rowOf(list, particles, i, 8);
                for (std::ptrdiff_t j = 0; j < particles.size(); ++j)
                {
                    const Vec apart = particles.r[i] - particles.r[j];
                    ASSERT_TRUE(i == j || apart.norm() >= R || row.contains(static_cast<int>(j)))
                        << i << " and " << j << " after " << steps + 1 << " steps";
                }
            }
        }
        EXPECT_GE(steps, 5);
        skin.forget();
        EXPECT_TRUE(skin.mustRebuild(particles, dt, largestSpeed(particles)));
    }
}

TEST(VerletSkin, OfAFewFastParticlesDoesNotWidenThatOfTheBulk)
{
    constexpr double R = 0.2, dt = 1e-4;
    Particles particles = randomParticles(2, 1000, 0, 6);
    std::fill(particles.v.begin(), particles.v.end(), Vec(0.5, 0, 0));
    VerletSkin calm, spray;
    calm.choose(particles, false, R, dt);
    particles.v[17] = Vec(0, 0, 5);
    spray.choose(particles, false, R, dt);
    EXPECT_GT(spray.skins()[17], 4 * calm.skins()[17]);
    EXPECT_NEAR(spray.skins()[3] - dt * 5 / 2, calm.skins()[3] - dt * 0.5 / 2, 0.02 * calm.skins()[3]);
    // Ten times as fast, it halves the steps between rebuilds; with one skin for all they would be a tenth.
    const auto stepsUntilRebuild = [&](VerletSkin& skin, Particles moving)
    {
        skin.listBuilt(moving);
        int steps = 0;
        for (; !skin.mustRebuild(moving, dt, largestSpeed(moving)); ++steps)
        {
            for (std::size_t i = 0; i < moving.r.size(); ++i)
            {
                moving.r[i] += dt * moving.v[i];
            }
        }
        return steps;
    };
    Particles without = particles;
    without.v[17] = Vec(0.5, 0, 0);
    EXPECT_GE(stepsUntilRebuild(spray, particles), stepsUntilRebuild(calm, without) * 0.4);
}

} // namespace
} // namespace slosh
