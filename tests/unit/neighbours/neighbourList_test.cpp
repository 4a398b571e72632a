// SPDX-License-Identifier: GPL-3.0-or-later
#include "randomParticles.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <omp.h>

namespace slosh
{
namespace
{

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
    seen.build(
        particles, reach, skins, 8,
        [&](std::ptrdiff_t a, std::ptrdiff_t b) { return particles.r[a].x() * particles.r[b].x() > 0; }
    );
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
            return std::count_if(
                records.begin(), records.end(),
                [&](std::ptrdiff_t record)
                { return particleOf(record) >= particles.nFluid && particleOf(record) < particles.size(); }
            );
        };
        const NeighbourRows::Row row = list.row(i), walls = list.wallPart(i);
        EXPECT_EQ(wallsIn(walls), wallsIn(row));
        EXPECT_LE(walls.groups, wallsIn(row) / 8 + 2);
        EXPECT_EQ(walls.groups == 0, wallsIn(row) == 0);
    }
}

} // namespace
} // namespace slosh
