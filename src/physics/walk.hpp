// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/parallel.hpp"
#include "base/simd.hpp"
#include "neighbours/NeighbourList.hpp"
#include "physics/Pair.hpp"
#include "physics/PairRecords.hpp"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <tuple>

namespace slosh
{

/// x_a - x_b in units of h; see PairRecords.
template <class S>
inline S positionDifference(const S& a, const S& b, RealOf<S> toSmoothingLengths)
{
    if constexpr (sizeof(RealOf<S>) == 4)
    {
        using I = typename ScalarTraits<S>::Integer;
        const I difference = std::bit_cast<I>(a) - std::bit_cast<I>(b);
        return ScalarTraits<S>::fromInteger(difference) * toSmoothingLengths;
    }
    else
    {
        return a - b;
    }
}

/// Calls add(pair) for the pairs of particle a in `row`, lanesOf<S> neighbours at a time. Entries of the list that are
/// outside the support come too, and padding records: kernels are 0 there. Always inlined, and its callers flattened:
/// left to itself gcc makes calls of it and of pieces of the vector library, and keeps the sums in memory, which costs
/// a third (docs/performance.md).
template <int dim, class S, class F>
[[gnu::always_inline]] inline void
forPairs(const PairRecords<RealOf<S>>& records, std::ptrdiff_t a, NeighbourRows::Row row, const F& add)
{
    constexpr int width = neighboursPerGroup(lanesOf<S>);
    Neighbour<dim, S> own;
    for (std::size_t c = 0; c < 8; ++c)
    {
        own.record[c] = S(records.of(a)[c]);
    }
    const RealOf<S> unit = records.toSmoothingLengths();
    for (std::ptrdiff_t group = 0; group < row.groups; ++group)
    {
        const std::ptrdiff_t first = row.first[group];
        const int liquidBelow = static_cast<int>(std::clamp<std::ptrdiff_t>(records.firstWall() - first, 0, 1 << 16));
        for (int k = 0; k < width; k += lanesOf<S>)
        {
            const std::uint16_t* const offset = row.offset + group * width + k;
            const Neighbour<dim, S> b{loadRecords<S>(records.data() + 8 * first, offset)};
            Pair<dim, S> pair{own, b, {}, {}, offset, liquidBelow};
            for (std::size_t d = 0; d < dim; ++d)
            {
                pair.x[d] = positionDifference<S>(own.record[slotX + d], b.record[slotX + d], unit);
            }
            pair.q2 = pair.x[0] * pair.x[0];
            for (std::size_t d = 1; d < dim; ++d)
            {
                pair.q2 += pair.x[d] * pair.x[d];
            }
            add(pair);
        }
    }
}

/// The only walk over pairs. For each of n particles a = particle(k): begin(a) makes the sums of its row, whose
/// add(pair) takes the pairs of rowOf(a), and finish(a, sums) takes what they have come to. On all threads, each row in
/// its own fixed order.
template <int dim, class S, class Particle, class RowOf, class Begin, class Finish>
void walk(
    const PairRecords<RealOf<S>>& records, std::ptrdiff_t n, const Particle& particle, const RowOf& rowOf,
    const Begin& begin, const Finish& finish
)
{
    parallelBlocks(
        n, particlesPerBlock,
        [&](std::ptrdiff_t first, std::ptrdiff_t last) __attribute__((flatten)) {
            for (std::ptrdiff_t k = first; k < last; ++k)
            {
                const std::ptrdiff_t a = particle(k);
                auto sums = begin(a);
                forPairs<dim, S>(records, a, rowOf(a), [&](const Pair<dim, S>& pair) { sums.add(pair); });
                finish(a, sums);
            }
        }
    );
}

/// Over the liquid's rows.
template <int dim, class S, class Begin, class Finish>
void walkLiquid(
    const PairRecords<RealOf<S>>& records, const NeighbourList& neighbours, std::ptrdiff_t nFluid, const Begin& begin,
    const Finish& finish
)
{
    walk<dim, S>(
        records, nFluid, [](std::ptrdiff_t k) { return k; }, [&](std::ptrdiff_t a) { return neighbours.row(a); }, begin,
        finish
    );
}

/// Over the rows of walls in reach of liquid.
template <int dim, class S, class Begin, class Finish>
void walkWalls(
    const PairRecords<RealOf<S>>& records, const NeighbourList& neighbours, const Begin& begin, const Finish& finish
)
{
    const auto& walls = neighbours.wallsInReach();
    walk<dim, S>(
        records, static_cast<std::ptrdiff_t>(walls.size()),
        [&](std::ptrdiff_t k) -> std::ptrdiff_t { return walls[k]; },
        [&](std::ptrdiff_t a) { return neighbours.row(a); }, begin, finish
    );
}

/// Sums of terms with the kernel's gradient, in one walk: add(pair, F) of each, F = (1/q) df/dq. F is evaluated here,
/// once a pair: where each term asked for it, gcc did not see that they are the same, and both rates with WendlandC2
/// took 1.27 times as long.
template <class Kernel, class... Sums>
struct GradientSums
{
    std::tuple<Sums...> sums;

    template <int dim, class S>
    void add(const Pair<dim, S>& pair)
    {
        const S F = Kernel::dfByQ(pair.q2);
        std::apply([&](auto&... sum) { (sum.add(pair, F), ...); }, sums);
    }
};

template <class Kernel, class... Sums>
GradientSums<Kernel, Sums...> gradientSums(const Sums&... sums)
{
    return {{sums...}};
}

} // namespace slosh
