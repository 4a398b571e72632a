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

/// Sums of terms over the pairs of lists: bricks are walked on all threads, and what they have come to is added in
/// their order, so that the bits do not depend on who walked which.
template <int dim, class S>
class PairSums
{
    using Real = RealOf<S>;

public:
    /// directions: the components of Vec that are not empty.
    PairSums(const std::array<int, 3>& directions, double smoothingLength, double supportRadius)
        : records_(directions, smoothingLength, supportRadius)
    {
    }

    /// What the sums are of.
    ClusterRecords<dim, Real>& records() { return records_; }
    std::size_t bytes() const { return records_.bytes() + sums_.capacity() * sizeof(Real); }

    /// Takes in the liquid as it is in `particles`, and sums over it for the walls in reach: termsOf(i) makes what
    /// liquid particle i gives to them, and finish(cluster, lane, w, sums) takes what the sums of wall particle w have
    /// come to.
    template <class TermsOf, class Finish>
    void ofWalls(const Particles& particles, const ClusterLists& lists, const TermsOf& termsOf, const Finish& finish)
    {
        constexpr std::size_t numbers = std::decay_t<decltype(termsOf(0))>::numbers;
        makeRoom(lists.wallSums() * numbers);
        forBricks(
            lists,
            [&](const ClusterLists::Brick& brick)
            {
                for (int own = 0; own < brick.own; ++own)
                {
                    records_.packLiquid(particles, lists.liquid(), brick.firstCluster + own);
                }
                if (brick.size() > brick.liquid)
                {
                    walk(
                        lists, brick, true, brick.firstWallSums * numbers, (brick.size() - brick.liquid) * numbers,
                        termsOf
                    );
                }
            }
        );
        const auto& walls = lists.wallsInReach();
        combine<numbers>(
            lists.wallSources(), lists.walls(), static_cast<std::ptrdiff_t>(walls.size()),
            [&](std::ptrdiff_t k) { return static_cast<std::ptrdiff_t>(walls[k]); }, finish
        );
    }

    /// The same for the liquid, over the pairs of liquid and those of liquid and walls, or over these alone: termsOf(a)
    /// makes the terms of particle a, and finish(a, sums) takes what its sums have come to.
    template <class TermsOf, class Finish>
    void ofLiquid(const ClusterLists& lists, bool wallsAlone, const TermsOf& termsOf, const Finish& finish) const
    {
        constexpr std::size_t numbers = std::decay_t<decltype(termsOf(0))>::numbers;
        makeRoom(lists.sums() * numbers);
        forBricks(
            lists, [&](const ClusterLists::Brick& brick)
            { walk(lists, brick, wallsAlone, brick.firstSums * numbers, brick.liquid * numbers, termsOf); }
        );
        combine<numbers>(
            lists.sources(), lists.liquid(), lists.liquid().clusters(), [](std::ptrdiff_t k) { return k; },
            [&](std::ptrdiff_t, int, std::ptrdiff_t a, const std::array<double, numbers>& sums) { finish(a, sums); }
        );
    }

private:
    template <class F>
    static void forBricks(const ClusterLists& lists, const F& f)
    {
        parallelTasks(
            static_cast<std::ptrdiff_t>(lists.bricks().size()), [&](std::ptrdiff_t b) { f(lists.bricks()[b]); }
        );
    }

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
        thread_local AlignedVector<Real> local;
        const std::size_t needed = ClusterRecords<dim, Real>::perCluster * brick.size();
        if (local.size() < needed)
        {
            local.resize(needed);
        }
        records_.gather(brick, wallsAlone, local.data());
        Real* const sums = sums_.data() + clusterSize * first;
        std::fill_n(sums, clusterSize * count, Real(0));
        BrickWalk<dim, S>{brick, lists.liquid(), local.data(), records_.toSmoothingLengths(), sums}.run(
            wallsAlone, termsOf
        );
    }

    /// finish(cluster, lane, point, sums) for the points of n clusters clusterOf(k).
    template <std::size_t numbers, class ClusterOf, class Finish>
    void combine(
        const ClusterLists::Sources& sources, const Clusters& clusters, std::ptrdiff_t n, const ClusterOf& clusterOf,
        const Finish& finish
    ) const
    {
        constexpr std::size_t perCluster = numbers * clusterSize;
        constexpr std::ptrdiff_t clustersPerBlock = particlesPerBlock / clusterSize;
        parallelBlocks(
            n, clustersPerBlock,
            [&](std::ptrdiff_t begin, std::ptrdiff_t end)
            {
                for (std::ptrdiff_t k = begin; k < end; ++k)
                {
                    const std::ptrdiff_t cluster = clusterOf(k);
                    alignas(64) std::array<Real, perCluster> total{};
                    for (const std::uint32_t place : sources.of(cluster))
                    {
                        const Real* const part = sums_.data() + perCluster * place;
                        for (std::size_t i = 0; i < perCluster; ++i)
                        {
                            total[i] += part[i];
                        }
                    }
                    const int first = clusters.firstPlace(cluster);
                    for (int lane = 0; lane < clusters.pointsIn(cluster); ++lane)
                    {
                        std::array<double, numbers> ofPoint;
                        for (std::size_t i = 0; i < numbers; ++i)
                        {
                            ofPoint[i] = static_cast<double>(total[clusterSize * i + lane]);
                        }
                        finish(cluster, lane, static_cast<std::ptrdiff_t>(clusters.point(first + lane)), ofPoint);
                    }
                }
            }
        );
    }

    ClusterRecords<dim, Real> records_;
    mutable AlignedVector<Real> sums_; ///< of one walk, brick after brick, cluster after cluster
};

} // namespace slosh
