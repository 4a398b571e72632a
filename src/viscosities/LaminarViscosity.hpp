// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "fluid/TaitEquation.hpp"
#include "viscosities/Coefficient.hpp"
#include "viscosities/LineViscosity.hpp"

#include <array>
#include <string_view>

namespace slosh
{

/// Viscosity of a Newtonian liquid, Monaghan & Gingold 1983 (J. Comput. Phys. 52, 374): along the line of centres, for
/// pairs that close in as for those that part,
///   Pi_ab = -2 (d + 2) nu (v_ab . r_ab) 2/((rho_a + rho_b)(r_ab^2 + 0.01 h^2)),
/// which keeps angular momentum and gives the right stress at a free surface (Colagrossi, Antuono & Souto-Iglesias
/// 2011, Phys. Rev. E 84, 026705). Liquid sticks to walls whose pairs count (no-slip, to first order in the spacing).
struct LaminarViscosity
{
    static constexpr std::string_view name = "laminar";
    static constexpr std::string_view sentence = "Newtonian liquid of kinematic viscosity nu, [m^2/s]";

    double nu = 0; ///< kinematic, [m^2/s]
    static constexpr std::array<Coefficient<LaminarViscosity>, 1> coefficients{
        {{{.name = "nu",
           .example = "1e-6",
           .unit = unit::kinematicViscosity,
           .range = notNegative,
           .sentence = "kinematic viscosity"},
          &LaminarViscosity::nu}}};

    static LaminarViscosity of(const TaitEquation&) { return {}; }
    double kinematic(int, double, double factor) const { return nu * factor; }

    template <class S>
    LineViscosity<S> inLoop(int dim, double h) const
    {
        return {static_cast<RealOf<S>>(-4 * (dim + 2) * nu / h), 0, 0};
    }
};

} // namespace slosh
