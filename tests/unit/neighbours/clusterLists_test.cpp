// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/threads.hpp"
#include "neighbours/sortByBrick.hpp"
#include "randomParticles.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

namespace slosh
{
namespace
{

/// Every pair nearer than `reach` is given once to each of both, and no other pair twice.
void expectThePairsOfASearchOverAll(
    const Particles& particles, const std::vector<int>& directions, double reach,
    const ClusterLists::Visible& visible = nullptr
)
{
    ClusterLists lists;
    lists.build(particles, directions, reach, visible);
    const ListedPairs listed(lists, particles.nFluid);
    const auto n = static_cast<int>(particles.size()), nFluid = static_cast<int>(particles.nFluid);
    int missing = 0, more = 0, seen = 0;
    for (int i = 0; i < nFluid; ++i)
    {
        for (int j = 0; j < n; ++j)
        {
            const bool near = i != j && (particles.r[i] - particles.r[j]).norm() < reach;
            const bool sees = !visible || visible(i, j);
            const std::size_t given = listed.given(i, j);
            missing += near && sees && given != 1;
            more += given > 1 || (!sees && near && given != 0);
            seen += near && sees;
        }
    }
    EXPECT_EQ(missing, 0);
    EXPECT_EQ(more, 0);
    EXPECT_GT(seen, 20);
}

TEST(ClusterLists, HoldEachPairThatASearchOverAllPairsFindsOnce)
{
    expectThePairsOfASearchOverAll(randomParticles(2, 500, 301, 3), {0, 2}, 0.21);
    expectThePairsOfASearchOverAll(randomParticles(3, 500, 301, 3), {0, 1, 2}, 0.21);
    expectThePairsOfASearchOverAll(randomParticles(3, 1800, 900, 3), {0, 1, 2}, 0.11);
}

TEST(ClusterLists, HoldThePairsOfTanksOfAnyShapeAndOfSprayFarAway)
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
        expectThePairsOfASearchOverAll(particles, {0, 1, 2}, 0.21);
    }
}

TEST(ClusterLists, LeaveOutTheParticlesThatAPlateHides)
{
    for (const int dim : {2, 3})
    {
        const Particles particles = randomParticles(dim, 600, 250, 12);
        // A plate at x = 0 that ends at z = 0.
        const auto visible = [&](std::ptrdiff_t i, std::ptrdiff_t j)
        {
            const Vec &a = particles.r[i], &b = particles.r[j];
            return a.x() * b.x() > 0 || (a.z() * b.x() - b.z() * a.x()) / (b.x() - a.x()) > 0;
        };
        expectThePairsOfASearchOverAll(particles, directionsOfRandom(dim), 0.25, visible);
        ClusterLists seen, all;
        seen.build(particles, directionsOfRandom(dim), 0.25, visible);
        all.build(particles, directionsOfRandom(dim), 0.25);
        const auto withHidden = [](const ClusterLists& lists)
        {
            return std::count_if(
                lists.bricks().begin(), lists.bricks().end(), [](const auto& brick) { return !brick.hidden.empty(); }
            );
        };
        EXPECT_GT(withHidden(seen), 0);
        EXPECT_EQ(withHidden(all), 0) << "what no plate is near to does not pay";
        ClusterLists open;
        open.build(particles, directionsOfRandom(dim), 0.25, [](std::ptrdiff_t, std::ptrdiff_t) { return true; });
        EXPECT_EQ(withHidden(open), 0);
    }
}

TEST(ClusterLists, HaveAWiderReachForParticlesWithWiderSkins)
{
    Particles particles = randomParticles(2, 700, 200, 8);
    std::vector<double> skins(particles.r.size(), 0.01);
    for (std::size_t i = 0; i < skins.size(); i += 20)
    {
        skins[i] = 0.1;
    }
    constexpr double R = 0.15;
    Clusters liquid;
    liquid.build(std::span<const Vec>(particles.r).first(700), std::span<const int>(particles.id).first(700), 3 * R);
    ClusterLists lists;
    lists.build(particles, std::move(liquid), std::array{0, 2}, R, skins, false);
    const ListedPairs listed(lists, 700);
    for (int i = 0; i < 700; ++i)
    {
        for (int j = 0; j < 900; ++j)
        {
            if (i != j && (particles.r[i] - particles.r[j]).norm() < R + skins[i] + skins[j])
            {
                ASSERT_EQ(listed.given(i, j), 1) << i << " and " << j;
            }
        }
    }
}

/// All that a walk reads.
std::vector<long> numbersOf(const ClusterLists& lists)
{
    std::vector<long> numbers{lists.sums(), lists.wallSums()};
    for (const ClusterLists::Brick& brick : lists.bricks())
    {
        numbers.insert(numbers.end(), {brick.firstCluster, brick.own, brick.liquid, brick.size()});
        numbers.insert(numbers.end(), brick.others.begin(), brick.others.end());
        numbers.insert(numbers.end(), brick.entries.begin(), brick.entries.end());
        for (const ClusterLists::Row& row : brick.rows)
        {
            numbers.insert(numbers.end(), {row.walls, row.both});
        }
        numbers.insert(numbers.end(), brick.reached.begin(), brick.reached.end());
        numbers.insert(numbers.end(), brick.reachedWalls.begin(), brick.reachedWalls.end());
    }
    numbers.insert(numbers.end(), lists.sources().sums.begin(), lists.sources().sums.end());
    numbers.insert(numbers.end(), lists.wallSources().sums.begin(), lists.wallSources().sums.end());
    numbers.insert(numbers.end(), lists.wallsInReach().begin(), lists.wallsInReach().end());
    return numbers;
}

TEST(ClusterLists, AreTheSameAtAnyNumberOfThreads)
{
    const Particles particles = randomParticles(3, 3000, 1000, 5);
    const int before = threads();
    std::vector<std::vector<long>> lists;
    for (const int threads : {1, 2, 3, 4})
    {
        setThreads(threads);
        ClusterLists list;
        list.build(particles, std::array{0, 1, 2}, 0.1);
        lists.push_back(numbersOf(list));
    }
    setThreads(before);
    for (const auto& list : lists)
    {
        EXPECT_EQ(list, lists[0]);
    }
}

TEST(ClusterLists, AreAFunctionOfPositionsAndIdsWhateverWasBuiltBefore)
{
    const auto built = [](Particles particles, ClusterLists& lists)
    {
        const std::vector<double> skins(particles.r.size(), 0.01);
        lists.build(particles, sortByBrick(particles, 0.3), std::array{0, 1, 2}, 0.1, skins, false);
        return numbersOf(lists);
    };
    const Particles particles = randomParticles(3, 3000, 1000, 5);
    ClusterLists afresh, after;
    Particles moved = particles, shuffled = particles;
    for (std::ptrdiff_t i = 0; i < moved.nFluid; ++i)
    {
        moved.r[i] += Vec(0.3, 0.1, -0.2);
    }
    std::reverse(shuffled.r.begin(), shuffled.r.begin() + 3000);
    std::reverse(shuffled.id.begin(), shuffled.id.begin() + 3000);
    built(moved, after);
    EXPECT_EQ(built(shuffled, after), built(particles, afresh));
}

TEST(ClusterLists, GiveTheSumsOfAClusterToTheBricksThatReachIt)
{
    const Particles particles = randomParticles(3, 3000, 1000, 5);
    ClusterLists lists;
    lists.build(particles, std::array{0, 1, 2}, 0.1);
    std::vector<int> count(lists.sums(), 0), wallCount(lists.wallSums(), 0);
    for (std::ptrdiff_t c = 0; c < lists.liquid().clusters(); ++c)
    {
        EXPECT_FALSE(lists.sources().of(c).empty());
        EXPECT_TRUE(std::is_sorted(lists.sources().of(c).begin(), lists.sources().of(c).end()));
        for (const std::uint32_t sums : lists.sources().of(c))
        {
            ++count[sums];
        }
    }
    for (std::ptrdiff_t c = 0; c < lists.walls().clusters(); ++c)
    {
        for (const std::uint32_t sums : lists.wallSources().of(c))
        {
            ++wallCount[sums];
        }
    }
    EXPECT_EQ(std::count(count.begin(), count.end(), 1), lists.sums());
    EXPECT_EQ(std::count(wallCount.begin(), wallCount.end(), 1), lists.wallSums());
}

TEST(ClusterLists, OfNoLiquidAreEmpty)
{
    const Particles particles = randomParticles(3, 0, 100, 5);
    ClusterLists lists;
    lists.build(particles, std::array{0, 1, 2}, 0.1);
    EXPECT_TRUE(lists.bricks().empty());
    EXPECT_TRUE(lists.wallsInReach().empty());
    EXPECT_EQ(lists.sums(), 0);
}

} // namespace
} // namespace slosh
