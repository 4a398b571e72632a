#pragma once

#include "base/simd.hpp"
#include "neighbours/NeighbourList.hpp"
#include "physics/PairRecords.hpp"

#include <array>
#include <bit>
#include <cstddef>
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
    const S& v(int d) const { return record[slotV + static_cast<std::size_t>(d)]; }
};

/// Particle a and as many of its neighbours b as S has lanes.
template <int dim, class S>
struct Pair
{
    const Neighbour<dim, S>& a;
    const Neighbour<dim, S>& b;
    std::array<S, dim> x; ///< r_ab/h
    S q2;                 ///< (|r_ab|/h)^2
    const int* index;     ///< of b, lanesOf<S> of them; liquid comes before the walls

    /// v_ab . r_ab/h, [m/s]
    S approach() const
    {
        S sum = (a.v(0) - b.v(0)) * x[0];
        for (int d = 1; d < dim; ++d)
        {
            sum += (a.v(d) - b.v(d)) * x[static_cast<std::size_t>(d)];
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
/// that are outside the support come too, and the record nowhere: kernels are 0 there. Flattened: without it
/// gcc leaves pieces of the vector library as calls inside the loop, which costs a third (docs/performance.md).
template <int dim, class S, class F>
[[gnu::flatten]] inline void interact(const PairRecords<RealOf<S>>& records, std::ptrdiff_t a, NeighbourList::Row row,
                                      const F& f)
{
    Neighbour<dim, S> own;
    for (std::size_t c = 0; c < 8; ++c)
    {
        own.record[c] = S(records.data()[8 * a + static_cast<std::ptrdiff_t>(c)]);
    }
    const RealOf<S> unit = records.toSmoothingLengths();
    for (const int* k = row.begin; k != row.end; k += lanesOf<S>)
    {
        const Neighbour<dim, S> b{loadRecords<S>(records.data(), k)};
        Pair<dim, S> pair{own, b, {}, {}, k};
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

} // namespace slosh
