// SPDX-License-Identifier: GPL-3.0-or-later
#include "neighbours/ClusterLists.hpp"

#include "base/CaseError.hpp"
#include "base/boundingBox.hpp"
#include "base/parallel.hpp"
#include "neighbours/RowSearch.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace slosh
{

namespace
{

template <int dim>
bool findRows(
    const Particles& particles, const Clusters& liquid, const Clusters& walls, std::span<const int> directions,
    double supportRadius, std::span<const double> skins, const ClusterLists::Visible& visible,
    std::vector<ClusterLists::Brick>& bricks
)
{
    const std::span<const Vec> all(particles.r);
    const auto wall = all.subspan(particles.nFluid);
    const BoundingBox box = boundingBox(wall.empty() ? all : wall);
    const Vec origin = all.empty() ? Vec(Vec::Zero()) : Vec(box.center());
    const ListedPoints<dim> liquidPoints(liquid, all.first(particles.nFluid), skins, directions, origin);
    const ListedPoints<dim> wallPoints(walls, wall, skins.subspan(particles.nFluid), directions, origin);
    const double widest = skins.empty() ? 0 : *std::max_element(skins.begin(), skins.end());
    // What rounding may take from a distance.
    const double rounding = 4e-7 * std::max(liquidPoints.extent(), wallPoints.extent()) + 1e-6 * supportRadius;
    const auto reach = static_cast<float>(supportRadius + rounding);
    bricks.resize(liquid.bricks());
    std::vector<char> fits(liquid.bricks(), 1);
    constexpr std::ptrdiff_t atATime = 4; // what a search collects is kept for the next
    parallelBlocks(
        liquid.bricks(), atATime,
        [&](std::ptrdiff_t begin, std::ptrdiff_t end)
        {
            RowSearch<dim> search(liquid, walls, liquidPoints, wallPoints, reach, reach + 2 * widest);
            for (std::ptrdiff_t b = begin; b < end; ++b)
            {
                fits[b] = search.fill(bricks[b], b, visible) ? 1 : 0;
            }
        }
    );
    return std::count(fits.begin(), fits.end(), 0) == 0;
}

/// Sources of `clusters` clusters, of which forEach(f) calls f(cluster, sums) for all sums in their order.
template <class ForEach>
void collectSources(std::ptrdiff_t clusters, const ForEach& forEach, ClusterLists::Sources& sources)
{
    sources.first.assign(clusters + 1, 0);
    forEach([&](int cluster, std::ptrdiff_t) { ++sources.first[cluster + 1]; });
    std::partial_sum(sources.first.begin(), sources.first.end(), sources.first.begin());
    sources.sums.resize(sources.first.back());
    std::vector<std::uint32_t> next(sources.first.begin(), sources.first.end() - 1);
    forEach([&](int cluster, std::ptrdiff_t sums) { sources.sums[next[cluster]++] = static_cast<std::uint32_t>(sums); }
    );
}

/// The bricks of `clusters` that have some of those with the local numbers [begin, end) of `brick`.
std::vector<int> bricksOf(const Clusters& clusters, const ClusterLists::Brick& brick, int begin, int end)
{
    std::vector<int> bricks;
    for (int local = begin; local < end; ++local)
    {
        const int cluster = brick.cluster(local);
        if (bricks.empty() || cluster < clusters.firstCluster(bricks.back()) ||
            cluster >= clusters.firstCluster(bricks.back() + 1))
        {
            bricks.push_back(static_cast<int>(clusters.brickOf(cluster)));
        }
    }
    std::sort(bricks.begin(), bricks.end());
    bricks.erase(std::unique(bricks.begin(), bricks.end()), bricks.end());
    return bricks;
}

void count(const std::vector<int>& bricks, std::vector<int>& counts)
{
    for (const int brick : bricks)
    {
        ++counts[brick];
    }
}

} // namespace

void ClusterLists::build(
    const Particles& particles, Clusters liquid, std::span<const int> directions, double supportRadius,
    std::span<const double> skins, bool wallsMove, const Visible& visible
)
{
    liquid_ = std::move(liquid);
    const std::ptrdiff_t n = particles.nFluid;
    const std::ptrdiff_t wallsBefore = walls_.firstPlace(walls_.clusters());
    if (wallsMove || wallsBefore != particles.nWall || walls_.brickEdge() != liquid_.brickEdge())
    {
        walls_.build(
            std::span<const Vec>(particles.r).subspan(n), std::span<const int>(particles.id).subspan(n),
            liquid_.brickEdge()
        );
    }
    const auto find = directions.size() == 2 ? findRows<2> : findRows<3>;
    if (!find(particles, liquid_, walls_, directions, supportRadius, skins, visible, bricks_))
    {
        throw CaseError("more than 65535 clusters of 8 particles are within reach of the particles of one brick: "
                        "particles are far closer to each other than particleSpacing");
    }
    countSums();
}

void ClusterLists::build(
    const Particles& particles, std::span<const int> directions, double reach, const Visible& visible
)
{
    Clusters liquid;
    liquid.build(
        std::span<const Vec>(particles.r).first(particles.nFluid),
        std::span<const int>(particles.id).first(particles.nFluid), 4 * reach
    );
    const std::vector<double> none(particles.r.size(), 0.0);
    build(particles, std::move(liquid), directions, reach, none, true, visible);
}

void ClusterLists::countSums()
{
    sums_ = wallSums_ = 0;
    sources_.bricks.assign(liquid_.bricks(), 0);
    wallSources_.bricks.assign(walls_.bricks(), 0);
    for (Brick& brick : bricks_)
    {
        brick.firstSums = sums_;
        brick.firstWallSums = wallSums_;
        sums_ += brick.liquid;
        wallSums_ += brick.size() - brick.liquid;
        brick.reached = bricksOf(liquid_, brick, 0, brick.liquid);
        brick.reachedWalls = bricksOf(walls_, brick, brick.liquid, brick.size());
        count(brick.reached, sources_.bricks);
        count(brick.reachedWalls, wallSources_.bricks);
    }
    collectSources(
        liquid_.clusters(),
        [&](const auto& f)
        {
            for (const Brick& brick : bricks_)
            {
                for (int local = 0; local < brick.liquid; ++local)
                {
                    f(brick.cluster(local), brick.firstSums + local);
                }
            }
        },
        sources_
    );
    collectSources(
        walls_.clusters(),
        [&](const auto& f)
        {
            for (const Brick& brick : bricks_)
            {
                for (int local = brick.liquid; local < brick.size(); ++local)
                {
                    f(brick.cluster(local), brick.firstWallSums + local - brick.liquid);
                }
            }
        },
        wallSources_
    );
    wallsInReach_.clear();
    for (int c = 0; c < walls_.clusters(); ++c)
    {
        if (!wallSources_.of(c).empty())
        {
            wallsInReach_.push_back(c);
        }
    }
}

std::size_t ClusterLists::bytes() const
{
    std::size_t sum = liquid_.bytes() + walls_.bytes() + wallsInReach_.capacity() * sizeof(int);
    for (const Sources* sources : {&sources_, &wallSources_})
    {
        sum += (sources->first.capacity() + sources->sums.capacity()) * sizeof(std::uint32_t) +
               sources->bricks.capacity() * sizeof(int);
    }
    sum += bricks_.capacity() * sizeof(Brick);
    for (const Brick& brick : bricks_)
    {
        sum += (brick.others.capacity() + brick.reached.capacity() + brick.reachedWalls.capacity()) * sizeof(int) +
               brick.hidden.capacity() + brick.rows.capacity() * sizeof(Row) +
               brick.entries.capacity() * sizeof(std::uint16_t);
    }
    return sum;
}

} // namespace slosh
