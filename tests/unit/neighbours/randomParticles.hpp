// SPDX-License-Identifier: GPL-3.0-or-later
// Particles at random, and the pairs of their lists.
#pragma once

#include "neighbours/ClusterLists.hpp"

#include <array>
#include <random>
#include <set>
#include <utility>
#include <vector>

namespace slosh
{

inline Particles randomParticles(int dim, int fluid, int wall, unsigned seed)
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
    particles.spacing = 0.05;
    return particles;
}

/// The directions of randomParticles(dim, ...) that are not empty.
inline std::vector<int> directionsOfRandom(int dim)
{
    return dim == 2 ? std::vector{0, 2} : std::vector{0, 1, 2};
}

/// The pairs that a walk over the rows gives to both, those of a cluster with itself, and those with walls: a, and each
/// particle of the cluster that is not hidden.
struct ListedPairs
{
    std::multiset<std::pair<int, int>> both, own, walls;

    explicit ListedPairs(const ClusterLists& lists, std::ptrdiff_t nFluid)
    {
        for (const ClusterLists::Brick& brick : lists.bricks())
        {
            const std::uint16_t* entry = brick.entries.data();
            const ClusterLists::Row* row = brick.rows.data();
            for (int cluster = 0; cluster < brick.own; ++cluster)
            {
                const int first = lists.liquid().firstPlace(brick.firstCluster + cluster);
                const int size = lists.liquid().pointsIn(brick.firstCluster + cluster);
                for (int lane = 0; lane < size; lane += brick.particlesOfRow, ++row)
                {
                    const std::uint16_t* const walled = entry + 1;
                    const std::uint16_t* const shared = walled + row->walls;
                    const std::uint16_t* const end = shared + row->both;
                    for (int k = lane; k < std::min(lane + brick.particlesOfRow, size); ++k)
                    {
                        const int a = lists.liquid().point(first + k);
                        const auto addAll = [&](const std::uint16_t* from, const std::uint16_t* to, auto& pairs)
                        {
                            for (; from != to; ++from)
                            {
                                add(lists, brick, a, *from, nFluid, pairs);
                            }
                        };
                        addAll(entry, walled, own);
                        addAll(walled, shared, walls);
                        addAll(shared, end, both);
                    }
                    entry = end;
                }
            }
        }
    }

    /// How often a walk gives j to the sums of i.
    std::size_t given(int i, int j) const
    {
        return both.count({i, j}) + both.count({j, i}) + own.count({i, j}) + walls.count({i, j});
    }

private:
    static void
    add(const ClusterLists& lists, const ClusterLists::Brick& brick, int a, int local, std::ptrdiff_t nFluid,
        std::multiset<std::pair<int, int>>& pairs)
    {
        const bool isWall = local >= brick.liquid;
        const Clusters& clusters = isWall ? lists.walls() : lists.liquid();
        const int cluster = brick.cluster(local);
        for (int lane = 0; lane < clusters.pointsIn(cluster); ++lane)
        {
            const bool hidden = !brick.hidden.empty() && ((brick.hidden[local] >> lane) & 1) != 0;
            const int b = clusters.point(clusters.firstPlace(cluster) + lane) + (isWall ? static_cast<int>(nFluid) : 0);
            if (!hidden && b != a)
            {
                pairs.insert({a, b});
            }
        }
    }
};

} // namespace slosh
