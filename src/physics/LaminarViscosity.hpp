// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/simd.hpp"
#include "physics/interact.hpp"

#include <limits>
#include <string_view>

namespace slosh
{

/// Viscosity of a Newtonian liquid, Monaghan & Gingold 1983 (J. Comput. Phys. 52, 374): along the line of centres, for
/// pairs that close in as for those that part,
///   Pi_ab = -2 (d + 2) nu (v_ab . r_ab) 2/((rho_a + rho_b)(r_ab^2 + 0.01 h^2)),
/// which keeps angular momentum and gives the right stress at a free surface (Colagrossi, Antuono & Souto-Iglesias
/// 2011, Phys. Rev. E 84, 026705). Liquid sticks to walls (no-slip, to first order in the spacing); where it slips
/// along them their pairs are left out, so that they take no stress, as the free surface does.
struct LaminarViscosity
{
    static constexpr std::string_view name = "laminar";

    double nu = 0;                                  ///< kinematic, [m^2/s]
    double smoothingLength = 0;                     ///< h, [m]
    int partners = std::numeric_limits<int>::max(); ///< particles from this index on do not take part

    template <class S>
    struct InLoop
    {
        RealOf<S> perDimension;  ///< -4 nu/h, times d + 2
        std::ptrdiff_t partners; ///< as a record

        template <int dim>
        S operator()(const Pair<dim, S>& pair, const S& approach) const
        {
            const S& s_a = pair.a.s();
            const S& s_b = pair.b.s();
            const auto below = static_cast<int>(std::clamp<std::ptrdiff_t>(partners - pair.first, 0, 1 << 16));
            return whereBelow(below, pair.offset,
                              (RealOf<S>(dim + 2) * perDimension) * approach * s_a * s_b /
                                  ((s_a + s_b) * (pair.q2 + RealOf<S>(0.01))));
        }
    };

    template <class S>
    InLoop<S> inLoop() const
    {
        return {static_cast<RealOf<S>>(-4 * nu / smoothingLength), recordOf(partners)};
    }
};

} // namespace slosh
