// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/alignedVector.hpp"
#include "base/parallel.hpp"
#include "physics/ClusterRecords.hpp"
#include "physics/walk.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

namespace slosh
{

/// What the sums of a cluster's particles have come to: number after number, those of its eight.
template <std::size_t numbers>
using ClusterSums = std::array<OfCluster<double>, numbers>;

/// f(point, its sums) for the points of a cluster.
template <std::size_t numbers, class F>
void forEachPoint(const Clusters& clusters, std::ptrdiff_t cluster, const ClusterSums<numbers>& sums, const F& f)
{
    const int first = clusters.firstPlace(cluster);
    for (int lane = 0; lane < clusters.pointsIn(cluster); ++lane)
    {
        std::array<double, numbers> ofPoint;
        for (std::size_t k = 0; k < numbers; ++k)
        {
            ofPoint[k] = sums[k][lane];
        }
        f(static_cast<std::ptrdiff_t>(clusters.point(first + lane)), ofPoint);
    }
}

/// Sums of terms over the pairs of lists: bricks are walked on all threads, and what they have come to is added in
/// their order, so that the bits do not depend on who walked which. The sums of a brick's particles are added as soon
/// as all bricks that have some are walked.
template <int dim, class S>
class PairSums
{
    using Real = RealOf<S>;
    using Points = std::array<std::ptrdiff_t, rowsOf<S>>;

public:
    /// directions: the components of Vec that are not empty.
    PairSums(const std::array<int, 3>& directions, double smoothingLength, double supportRadius)
        : records_(directions, smoothingLength, supportRadius)
    {
    }

    /// What the sums are of.
    ClusterRecords<dim, Real>& records() { return records_; }
    std::size_t bytes() const { return records_.bytes() + sums_.capacity() * sizeof(Real); }

    /// To be called for every new list; `margin` as of ClusterRecords.
    void listBuilt(const Particles& particles, const ClusterLists& lists, double margin)
    {
        records_.listBuilt(particles, lists, margin);
        waiting_.start(lists.sources().bricks);
        waitingWalls_.start(lists.wallSources().bricks);
    }

    /// Takes in the liquid as it is in `particles`, after prepare(begin, end) of the places of each brick, and sums
    /// over it for the walls in reach: termsOf(points) makes what liquid particles, one in each row of S, give to them,
    /// and finish(cluster, sums) takes what the sums of a cluster of walls have come to.
    template <class Prepare, class TermsOf, class Finish>
    void ofWalls(
        const Particles& particles, const ClusterLists& lists, const Prepare& prepare, const TermsOf& termsOf,
        const Finish& finish
    )
    {
        constexpr std::size_t numbers = std::decay_t<decltype(termsOf(Points()))>::numbers;
        makeRoom(lists.wallSums() * numbers);
        parallelTasks(
            static_cast<std::ptrdiff_t>(lists.bricks().size()),
            [&](std::ptrdiff_t b)
            {
                const ClusterLists::Brick& brick = lists.bricks()[b];
                const Clusters& liquid = lists.liquid();
                prepare(liquid.firstPlace(brick.firstCluster), liquid.firstPlace(brick.firstCluster + brick.own));
                for (int own = 0; own < brick.own; ++own)
                {
                    records_.packLiquid(particles, liquid, brick.firstCluster + own);
                }
                if (brick.size() == brick.liquid)
                {
                    return;
                }
                walk(
                    lists, brick, true, brick.firstWallSums * numbers, (brick.size() - brick.liquid) * numbers, termsOf
                );
                for (const int reached : brick.reachedWalls)
                {
                    if (waitingWalls_.isLast(reached))
                    {
                        combine<numbers>(lists.wallSources(), lists.walls(), reached, finish);
                    }
                }
            }
        );
    }

    /// The same for the liquid, over the pairs of liquid and those of liquid and walls, or over these alone:
    /// termsOf(points) makes the terms of particles, one in each row, and finish(a, sums) takes what its sums have come
    /// to.
    template <class TermsOf, class Finish>
    void ofLiquid(const ClusterLists& lists, bool wallsAlone, const TermsOf& termsOf, const Finish& finish) const
    {
        constexpr std::size_t numbers = std::decay_t<decltype(termsOf(Points()))>::numbers;
        makeRoom(lists.sums() * numbers);
        parallelTasks(
            static_cast<std::ptrdiff_t>(lists.bricks().size()),
            [&](std::ptrdiff_t b)
            {
                const ClusterLists::Brick& brick = lists.bricks()[b];
                walk(lists, brick, wallsAlone, brick.firstSums * numbers, brick.liquid * numbers, termsOf);
                for (const int reached : brick.reached)
                {
                    if (waiting_.isLast(reached))
                    {
                        combine<numbers>(
                            lists.sources(), lists.liquid(), reached,
                            [&](std::ptrdiff_t cluster, const ClusterSums<numbers>& sums)
                            { forEachPoint(lists.liquid(), cluster, sums, finish); }
                        );
                    }
                }
            }
        );
    }

private:
    void makeRoom(std::size_t numbers) const
    {
        if (sums_.size() < numbers * clusterSize)
        {
            sums_.resize(numbers * clusterSize);
        }
    }

    /// The sums of a brick's rows: `count` numbers of clusters from number `first` on.
    template <class TermsOf>
    void walk(
        const ClusterLists& lists, const ClusterLists::Brick& brick, bool wallsAlone, std::size_t first,
        std::size_t count, const TermsOf& termsOf
    ) const
    {
        using ToB = SumsOfCluster<S>;
        thread_local AlignedVector<Real> local, parts;
        local.resize(std::max(local.size(), ClusterRecords<dim, Real>::perCluster * brick.size()));
        parts.resize(std::max(parts.size(), ToB::perNumber * count));
        records_.gather(brick, wallsAlone, local.data());
        std::fill_n(parts.begin(), ToB::perNumber * count, Real(0));
        const BrickWalk<dim, S> walk{
            brick, lists.liquid(), local.data(), records_.farAway(), records_.toSmoothingLengths(), parts.data()};
        walk.run(wallsAlone, termsOf);
        Real* const sums = sums_.data() + clusterSize * first;
        for (std::size_t k = 0; k < count; ++k)
        {
            for (int lane = 0; lane < clusterSize; lane += lanesOf<RowOf<S>>)
            {
                store(ToB::total(&parts[k * ToB::perNumber], lane), sums + k * clusterSize + lane);
            }
        }
    }

    /// finish(cluster, sums) for a brick's clusters that have sums.
    template <std::size_t numbers, class Finish>
    void combine(
        const ClusterLists::Sources& sources, const Clusters& clusters, std::ptrdiff_t brick, const Finish& finish
    ) const
    {
        constexpr std::size_t perCluster = numbers * clusterSize;
        for (std::ptrdiff_t cluster = clusters.firstCluster(brick); cluster < clusters.firstCluster(brick + 1);
             ++cluster)
        {
            const auto parts = sources.of(cluster);
            if (parts.empty())
            {
                continue;
            }
            alignas(64) std::array<Real, perCluster> total{};
            for (const std::uint32_t place : parts)
            {
                const Real* const part = sums_.data() + perCluster * place;
                for (std::size_t i = 0; i < perCluster; ++i)
                {
                    total[i] += part[i];
                }
            }
            ClusterSums<numbers> sums;
            for (std::size_t k = 0; k < numbers; ++k)
            {
                std::copy_n(&total[k * clusterSize], clusterSize, sums[k].begin());
            }
            finish(cluster, sums);
        }
    }

    ClusterRecords<dim, Real> records_;
    mutable AlignedVector<Real> sums_; ///< of one walk, brick after brick, cluster after cluster
    mutable Countdowns waiting_;       ///< bricks, for sums of theirs
    Countdowns waitingWalls_;
};

} // namespace slosh
