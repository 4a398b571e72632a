// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/simd.hpp"
#include "base/unrolled.hpp"
#include "neighbours/ClusterLists.hpp"
#include "physics/Pair.hpp"
#include "physics/Sums.hpp"

#include <array>
#include <cstddef>
#include <tuple>

namespace slosh
{

/// x_a - x_b in units of h; see ClusterRecords.
template <class S>
[[gnu::always_inline]] inline S positionDifference(const S& a, const S& b, RealOf<S> toSmoothingLengths)
{
    if constexpr (sizeof(RealOf<S>) == 4)
    {
        using I = typename ScalarTraits<S>::Integer;
        const I difference = withBitsOf<I>(a) - withBitsOf<I>(b);
        return ScalarTraits<S>::fromInteger(difference) * broadcast<S>(toSmoothingLengths);
    }
    else
    {
        return a - b;
    }
}

/// What the rows of a brick are walked with.
template <int dim, class S>
struct BrickWalk
{
    using Real = RealOf<S>;
    static constexpr int lanes = lanesOf<S>;
    static constexpr std::size_t perCluster = Neighbour<dim, S>::numbers * clusterSize;

    const ClusterLists::Brick& brick;
    const Clusters& liquid;
    const Real* local; ///< records of the brick's clusters, ClusterRecords::gather
    Real unit;         ///< ClusterRecords::toSmoothingLengths
    Real* sums;        ///< of the brick's clusters of liquid, or of terms `ofWalls` those of its walls: to be added to

    /// Rows of terms: termsOf(i) makes those of particle i, whose add(pair, a, b) gives to the sums of a and of b. Of
    /// pairs with walls alone if `wallsAlone`. Flattened: left to itself gcc makes calls of pieces of the vector
    /// library and keeps sums in memory, which costs a third.
    template <class TermsOf>
    [[gnu::flatten]] void run(bool wallsAlone, const TermsOf& termsOf) const
    {
        using Terms = std::decay_t<decltype(termsOf(0))>;
        constexpr std::size_t numbers = Terms::numbers, perSums = numbers * clusterSize;
        constexpr bool ofWalls = requires
        {
            Terms::ofWalls;
        };
        const ClusterLists::Row* row = brick.rows.data();
        const std::uint16_t* entry = brick.entries.data();
        for (int own = 0; own < brick.own; ++own)
        {
            const int first = liquid.firstPlace(brick.firstCluster + own);
            const int size = liquid.pointsIn(brick.firstCluster + own);
            std::array<std::array<S, clusterSize>, numbers> rows{};
            for (int lane = 0; lane < size; ++lane, ++row)
            {
                const auto a = broadcastRecord(local + perCluster * own + lane);
                const auto terms = termsOf(liquid.point(first + lane));
                std::array<S, numbers> sum{};
                const SumsOfRow<S> toA{sum.data()};
                if (!ofWalls && !wallsAlone)
                {
                    addPairs<false>(a, *entry, terms, toA, [](int) { return NoSums{}; });
                }
                const std::uint16_t* const walls = entry + 1;
                const std::uint16_t* const both = walls + row->walls;
                entry = both + row->both;
                for (const std::uint16_t* b = walls; b != both; ++b)
                {
                    if constexpr (ofWalls)
                    {
                        Real* const sumsOfWalls = sums + perSums * (*b - brick.liquid);
                        addPairs<true>(
                            a, *b, terms, NoSums{},
                            [=](int k) { return SumsOfCluster<S, clusterSize>{sumsOfWalls + k}; }
                        );
                    }
                    else
                    {
                        addPairs<true>(a, *b, terms, toA, [](int) { return NoSums{}; });
                    }
                }
                if constexpr (!ofWalls)
                {
                    for (const std::uint16_t *b = both, *const end = wallsAlone ? both : entry; b != end; ++b)
                    {
                        Real* const sumsOfB = sums + perSums * *b;
                        addPairs<false>(
                            a, *b, terms, toA, [=](int k) { return SumsOfCluster<S, clusterSize>{sumsOfB + k}; }
                        );
                    }
                    unrolled<numbers>([&](auto k) __attribute__((always_inline)) { rows[k][lane] = sum[k]; });
                }
            }
            if constexpr (!ofWalls)
            {
                for (std::size_t k = 0; k < numbers; ++k)
                {
                    for (int lane = 0; lane < clusterSize; lane += lanes)
                    {
                        Real* const to = sums + perSums * own + clusterSize * k + lane;
                        store(load<S>(to) + rowSums(&rows[k][lane]), to);
                    }
                }
            }
        }
    }

private:
    [[gnu::always_inline]] static Neighbour<dim, S> broadcastRecord(const Real* record)
    {
        Neighbour<dim, S> a;
        unrolled<dim>([&](auto d) __attribute__((always_inline)) {
            a.x[d] = broadcast<S>(record[clusterSize * d]);
            a.v[d] = broadcast<S>(record[clusterSize * (dim + d)]);
        });
        a.P = broadcast<S>(record[clusterSize * (2 * dim)]);
        a.s = broadcast<S>(record[clusterSize * (2 * dim + 1)]);
        return a;
    }

    /// The pairs of a and a cluster. Some are outside the support, and some are padding: kernels are 0 there.
    template <bool ofWalls, class Terms, class ToA, class ToB>
    [[gnu::always_inline]] void
    addPairs(const Neighbour<dim, S>& a, int cluster, const Terms& terms, const ToA& toA, const ToB& toB) const
    {
        for (int lane = 0; lane < clusterSize; lane += lanes)
        {
            const Real* const record = local + perCluster * cluster + lane;
            Neighbour<dim, S> b;
            Pair<dim, S, ofWalls> pair{a, b, {}, {}, {}};
            std::array<S, dim> v;
            unrolled<dim>([&](auto d) __attribute__((always_inline)) {
                b.x[d] = load<S>(record + clusterSize * d);
                b.v[d] = load<S>(record + clusterSize * (dim + d));
                pair.x[d] = positionDifference<S>(a.x[d], b.x[d], unit);
                v[d] = a.v[d] - b.v[d];
            });
            b.P = load<S>(record + clusterSize * (2 * dim));
            b.s = load<S>(record + clusterSize * (2 * dim + 1));
            pair.q2 = dot(pair.x, pair.x);
            pair.approach = dot(v, pair.x);
            terms.add(pair, toA, toB(lane));
        }
    }
};

/// Terms with the kernel's gradient, in one walk: add(pair, F, a, b) of each, F = (1/q) df/dq. F is evaluated here,
/// once a pair: where each term asked for it, gcc did not see that they are the same, and both rates with WendlandC2
/// took 1.27 times as long.
template <class Kernel, class... Terms>
struct GradientSums
{
    static constexpr std::size_t numbers = (Terms::numbers + ...);
    std::tuple<Terms...> terms;

    template <class Pair, class SumsA, class SumsB>
    [[gnu::always_inline]] void add(const Pair& pair, const SumsA& a, const SumsB& b) const
    {
        const auto F = Kernel::dfByQ(pair.q2);
        unrolled<sizeof...(Terms)>([&](auto k) __attribute__((always_inline)) {
            constexpr std::size_t first = firstNumber(k);
            std::get<k>(terms).add(pair, F, a.from(first), b.from(first));
        });
    }

private:
    static constexpr std::size_t firstNumber(std::size_t term)
    {
        std::size_t sum = 0, k = 0;
        ((sum += k++ < term ? Terms::numbers : 0), ...);
        return sum;
    }
};

template <class Kernel, class... Terms>
GradientSums<Kernel, Terms...> gradientSums(const Terms&... terms)
{
    return {{terms...}};
}

} // namespace slosh
