// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Zero.hpp"
#include "base/scalarMath.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

namespace slosh
{

/// The slots of a pair record. Positions and velocities hold the directions that are not empty, in their order; the
/// third of each is unused in 2D.
enum Slot : std::size_t
{
    slotX = 0, ///< three positions
    slotP = 3, ///< P = p/rho^2, [Pa m^6/kg^2]
    slotV = 4, ///< three velocities, [m/s]
    slotS = 7  ///< s = 1/rho, [m^3/kg]
};

/// A particle's record as numbers of type S; of a itself the same in every lane, of its neighbours one in each.
template <int dim, class S>
struct Neighbour
{
    std::array<S, 8> record;

    const S& P() const { return record[slotP]; } ///< p/rho^2
    const S& s() const { return record[slotS]; } ///< 1/rho
    const S& v(int d) const { return record[slotV + d]; }
};

/// Particle a and as many of its neighbours b as S has lanes: all that a term sees.
template <int dim, class S>
struct Pair
{
    const Neighbour<dim, S>& a;
    const Neighbour<dim, S>& b;
    std::array<S, dim> x; ///< r_ab/h
    S q2;                 ///< (|r_ab|/h)^2
    // Which lanes hold liquid: those whose number is below the bound.
    const std::uint16_t* number;
    int liquidBelow;

    /// y where b is liquid, 0 in the other lanes.
    S ofLiquid(const S& y) const { return whereBelow(liquidBelow, number, y); }
    /// The same where `alone`, else y.
    S ofLiquidAlone(bool alone, const S& y) const { return whereBelow(alone ? liquidBelow : 1 << 16, number, y); }
    Zero ofLiquidAlone(bool, Zero) const { return {}; }
    /// y where b is a wall, 0 in the other lanes.
    S ofWalls(const S& y) const { return y - ofLiquid(y); }

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

} // namespace slosh
