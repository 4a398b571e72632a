// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/scalarMath.hpp"
#include "base/unrolled.hpp"

#include <array>
#include <cstddef>

namespace slosh
{

/// What a pair needs of a particle: of a itself the same in every lane, of its neighbours one in each.
template <int dim, class S>
struct Neighbour
{
    static constexpr std::size_t numbers = 2 * dim + 2;
    std::array<S, dim> x; ///< position, as ClusterRecords packs it
    std::array<S, dim> v; ///< [m/s]
    S P;                  ///< p/rho^2, [Pa m^6/kg^2]
    S s;                  ///< 1/rho, [m^3/kg]
};

/// Particle a and as many of its neighbours b as S has lanes: all that a term sees.
template <int dim, class S, bool ofWalls>
struct Pair
{
    static constexpr bool withWall = ofWalls; ///< b are walls
    const Neighbour<dim, S>& a;
    const Neighbour<dim, S>& b;
    std::array<S, dim> x; ///< r_ab/h
    S q2;                 ///< (|r_ab|/h)^2
    S approach;           ///< v_ab . r_ab/h, [m/s]
};

/// a . b
template <class S, std::size_t n>
[[gnu::always_inline]] inline S dot(const std::array<S, n>& a, const std::array<S, n>& b)
{
    S sum = a[0] * b[0];
    unrolled<n - 1>([&](auto d) __attribute__((always_inline)) { sum = multiplyAdd(a[d + 1], b[d + 1], sum); });
    return sum;
}

} // namespace slosh
