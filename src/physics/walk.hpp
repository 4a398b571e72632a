// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/simd.hpp"
#include "base/unrolled.hpp"
#include "neighbours/ClusterLists.hpp"
#include "physics/Pair.hpp"
#include "physics/Sums.hpp"

#include <algorithm>
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
    static constexpr int lanesOfRow = lanesOf<S> / rowsOf<S>;
    static constexpr std::size_t perCluster = Neighbour<dim, S>::numbers * clusterSize;

    const ClusterLists::Brick& brick;
    const Clusters& liquid;
    const Real* local;   ///< records of the brick's clusters, ClusterRecords::gather
    const Real* farAway; ///< a record out of reach of all
    Real unit;           ///< ClusterRecords::toSmoothingLengths
    Real* sums;          ///< SumsOfCluster of the brick's liquid, or of terms `ofWalls` of its walls: to be added to

    /// Rows of terms: termsOf(points) makes those of the particles of as many rows as S stands for, whose add(pair, a,
    /// b) gives to the sums of a and of b. Of pairs with walls alone if `wallsAlone`. Flattened: left to itself gcc
    /// makes calls of pieces of the vector library and keeps sums in memory, which costs a third.
    template <class TermsOf>
    [[gnu::flatten]] void run(bool wallsAlone, const TermsOf& termsOf) const
    {
        using Terms = std::decay_t<decltype(termsOf(Points()))>;
        constexpr std::size_t numbers = Terms::numbers;
        const Records records{local, unit};
        const ClusterLists::Row* row = brick.rows.data();
        const std::uint16_t* entry = brick.entries.data();
        for (int own = 0; own < brick.own; ++own)
        {
            const int size = liquid.pointsIn(brick.firstCluster + own);
            std::array<std::array<RowOf<S>, clusterSize>, numbers> rows{};
            for (int begin = 0, end = 0; begin < size; begin = end, ++row)
            {
                end = rowsAtATime == 1 ? begin + 1 : std::min(begin + brick.particlesOfRow, size);
                const std::uint16_t* const walls = entry + 1;
                const std::uint16_t* const both = walls + row->walls;
                const Entries entries{entry, walls, both, both + row->both};
                for (int place = begin - begin % rowsOf<S>; place < end; place += rowsOf<S>)
                {
                    const Places places{place, begin, end};
                    const auto terms = termsOf(pointsAt(places, own));
                    const auto a = broadcastRecords(recordsAt(places, own));
                    std::array<S, numbers> sum{};
                    addRow(records, a, entries, wallsAlone, terms, sum.data(), place);
                    unrolled<rowsOf<S>>([&](auto r) __attribute__((always_inline)) {
                        if (!isOfWalls<Terms> && places.has(r))
                        {
                            unrolled<numbers>([&](auto k) __attribute__((always_inline)) {
                                rows[k][place + static_cast<int>(r)] = slosh::row<r>(sum[k]);
                            });
                        }
                    });
                }
                entry = entries.end;
            }
            if constexpr (!isOfWalls<Terms>)
            {
                addOwn(rows, sums + numbers * ToB::perNumber * own);
            }
        }
    }

private:
    using Points = std::array<std::ptrdiff_t, rowsOf<S>>;
    using ToB = SumsOfCluster<S>;

    /// Terms that liquid gives to walls alone.
    template <class Terms>
    static constexpr bool isOfWalls = requires
    {
        Terms::ofWalls;
    };

    /// Those of a row: its own cluster, those of walls from `walls` to `both`, and those of liquid from there to `end`.
    struct Entries
    {
        const std::uint16_t *own, *walls, *both, *end;
    };

    /// As many places of a cluster as S has rows, from `first` on; the row's particles are at [begin, end).
    struct Places
    {
        int first, begin, end;
        bool has(std::size_t r) const
        {
            const int place = first + static_cast<int>(r);
            return begin <= place && place < end;
        }
    };

    /// Local: compilers cannot know that the sums, which are written, are not among a walk's own members.
    struct Records
    {
        const Real* local;
        Real unit;
    };

    // Beside a particle that is alone in its row stands one that is far away.

    Points pointsAt(const Places& places, int own) const
    {
        const int first = liquid.firstPlace(brick.firstCluster + own);
        Points points;
        for (int r = 0; r < rowsOf<S>; ++r)
        {
            points[r] = liquid.point(first + (places.has(r) ? places.first + r : places.begin));
        }
        return points;
    }
    std::array<const Real*, rowsOf<S>> recordsAt(const Places& places, int own) const
    {
        std::array<const Real*, rowsOf<S>> record;
        for (int r = 0; r < rowsOf<S>; ++r)
        {
            record[r] = places.has(r) ? local + perCluster * own + places.first + r : farAway;
        }
        return record;
    }

    /// The pairs of a, which stand at `place`, with all entries of their row.
    template <class Terms>
    [[gnu::always_inline]] void addRow(
        const Records& records, const Neighbour<dim, S>& a, const Entries& entries, bool wallsAlone, const Terms& terms,
        S* sum, int place
    ) const
    {
        constexpr std::size_t perSums = Terms::numbers * ToB::perNumber;
        const auto toB = [=](Real* of) { return [=](int lane) { return ToB::of(of, lane, place); }; };
        if constexpr (isOfWalls<Terms>)
        {
            for (const std::uint16_t* b = entries.walls; b != entries.both; ++b)
            {
                addPairs<true>(records, a, *b, terms, NoSums{}, toB(sums + perSums * (*b - brick.liquid)));
            }
        }
        else
        {
            const SumsOfRow<S> toA{sum};
            const auto toNobody = [](int) { return NoSums{}; };
            if (!wallsAlone)
            {
                addPairs<false>(records, a, *entries.own, terms, toA, toNobody);
            }
            for (const std::uint16_t* b = entries.walls; b != entries.both; ++b)
            {
                addPairs<true>(records, a, *b, terms, toA, toNobody);
            }
            for (const std::uint16_t *b = entries.both, *const end = wallsAlone ? b : entries.end; b != end; ++b)
            {
                addPairs<false>(records, a, *b, terms, toA, toB(sums + perSums * *b));
            }
        }
    }

    /// What the rows of a cluster's particles have come to, to its sums.
    template <std::size_t numbers>
    static void addOwn(const std::array<std::array<RowOf<S>, clusterSize>, numbers>& rows, Real* sums)
    {
        for (std::size_t k = 0; k < numbers; ++k)
        {
            for (int lane = 0; lane < clusterSize; lane += lanesOfRow)
            {
                Real* const to = sums + ToB::perNumber * k + 2 * lane;
                store(load<RowOf<S>>(to) + rowSums(&rows[k][lane]), to);
            }
        }
    }

    [[gnu::always_inline]] static Neighbour<dim, S> broadcastRecords(const std::array<const Real*, rowsOf<S>>& record)
    {
        const auto number = [&](std::size_t k) __attribute__((always_inline))
        {
            PerRow<S> x;
            unrolled<rowsOf<S>>([&](auto r) __attribute__((always_inline)) { x[r] = record[r][clusterSize * k]; });
            return broadcast<S>(x);
        };
        Neighbour<dim, S> a;
        unrolled<dim>([&](auto d) __attribute__((always_inline)) {
            a.x[d] = number(d);
            a.v[d] = number(dim + d);
        });
        a.P = number(2 * dim);
        a.s = number(2 * dim + 1);
        return a;
    }

    /// The pairs of a, one in each row, and a cluster. Some are outside the support, and some are padding: kernels are
    /// 0 there.
    template <bool ofWalls, class Terms, class ToA, class ToB>
    [[gnu::always_inline]] static void addPairs(
        const Records& records, const Neighbour<dim, S>& a, int cluster, const Terms& terms, const ToA& toA,
        const ToB& toB
    )
    {
        for (int lane = 0; lane < clusterSize; lane += lanesOfRow)
        {
            const Real* const record = records.local + perCluster * cluster + lane;
            Neighbour<dim, S> b;
            Pair<dim, S, ofWalls> pair{a, b, {}, {}, {}};
            std::array<S, dim> v;
            unrolled<dim>([&](auto d) __attribute__((always_inline)) {
                b.x[d] = loadInRows<S>(record + clusterSize * d);
                b.v[d] = loadInRows<S>(record + clusterSize * (dim + d));
                pair.x[d] = positionDifference<S>(a.x[d], b.x[d], records.unit);
                v[d] = a.v[d] - b.v[d];
            });
            b.P = loadInRows<S>(record + clusterSize * (2 * dim));
            b.s = loadInRows<S>(record + clusterSize * (2 * dim + 1));
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
