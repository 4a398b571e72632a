// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Zero.hpp"
#include "base/simd.hpp"
#include "neighbours/NeighbourList.hpp"
#include "physics/PairRecords.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace slosh
{

/// A particle's record as numbers of type S; of a itself the same in every lane, of its neighbours one in each.
template <int dim, class S>
struct Neighbour
{
    std::array<S, 8> record;

    const S& P() const { return record[slotP]; } ///< p/rho^2
    const S& s() const { return record[slotS]; } ///< 1/rho
    const S& v(int d) const { return record[slotV + d]; }
};

/// Particle a and as many of its neighbours b as S has lanes.
template <int dim, class S>
struct Pair
{
    const Neighbour<dim, S>& a;
    const Neighbour<dim, S>& b;
    std::array<S, dim> x; ///< r_ab/h
    S q2;                 ///< (|r_ab|/h)^2
    std::ptrdiff_t first; ///< records of b: first + offset, lanesOf<S> of them
    const std::uint16_t* offset;

    /// x in the lanes whose particle b has a record before `partners`, 0 in the others.
    S whereBefore(std::ptrdiff_t partners, const S& x) const
    {
        return whereBelow(static_cast<int>(std::clamp<std::ptrdiff_t>(partners - first, 0, 1 << 16)), offset, x);
    }
    Zero whereBefore(std::ptrdiff_t, Zero) const { return {}; }

    /// v_ab . r_ab/h, [m/s]
    S approach() const
    {
        S sum = (a.v(0) - b.v(0)) * x[0];
        for (int d = 1; d < dim; ++d)
        {
            sum += (a.v(d) - b.v(d)) * x[d];
        }
        return sum;
    }
};

/// x_a - x_b in units of h; see PairRecords.
template <class S>
inline S positionDifference(const S& a, const S& b, RealOf<S> toSmoothingLengths)
{
    if constexpr (sizeof(RealOf<S>) == 4)
    {
        using I = typename ScalarTraits<S>::Integer;
        const I difference = std::bit_cast<I>(a) - std::bit_cast<I>(b);
        return std::experimental::static_simd_cast<S>(difference) * toSmoothingLengths;
    }
    else
    {
        return a - b;
    }
}

/// The only pair loop: calls f(pair) for the row of particle a, lanesOf<S> neighbours at a time. Entries of the list
/// that are outside the support come too, and padding records: kernels are 0 there. Always inlined, and its
/// callers flattened: left to itself gcc makes calls of it and of pieces of the vector library, and keeps the sums in
/// memory, which costs a third (docs/performance.md).
template <int dim, class S, class F>
[[gnu::always_inline]] inline void interact(const PairRecords<RealOf<S>>& records, std::ptrdiff_t a,
                                            NeighbourRows::Row row, const F& f)
{
    constexpr int width = neighboursAGroup(lanesOf<S>);
    Neighbour<dim, S> own;
    for (std::size_t c = 0; c < 8; ++c)
    {
        own.record[c] = S(records.of(a)[c]);
    }
    const RealOf<S> unit = records.toSmoothingLengths();
    for (std::ptrdiff_t group = 0; group < row.groups; ++group)
    {
        const std::ptrdiff_t first = row.first[group];
        for (int k = 0; k < width; k += lanesOf<S>)
        {
            const std::uint16_t* const offset = row.offset + group * width + k;
            const Neighbour<dim, S> b{loadRecords<S>(records.data() + 8 * first, offset)};
            Pair<dim, S> pair{own, b, {}, {}, first, offset};
            for (std::size_t d = 0; d < dim; ++d)
            {
                pair.x[d] = positionDifference<S>(own.record[slotX + d], b.record[slotX + d], unit);
            }
            pair.q2 = pair.x[0] * pair.x[0];
            for (std::size_t d = 1; d < dim; ++d)
            {
                pair.q2 += pair.x[d] * pair.x[d];
            }
            f(pair);
        }
    }
}

} // namespace slosh
