// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "fluid/TaitEquation.hpp"
#include "viscosities/Coefficient.hpp"
#include "viscosities/LineViscosity.hpp"

#include <array>
#include <string_view>

namespace slosh
{

/// Artificial viscosity of Monaghan: adds Pi_ab to p_a/rho_a^2 + p_b/rho_b^2.
///   Pi_ab = -alpha h (c_a + c_b) (v_ab . r_ab) / ((rho_a + rho_b)(r_ab^2 + 0.01 h^2)),  v_ab . r_ab < 0, else 0
/// with the speed of sound of Tait's equation to first order in the density,
///   c_a + c_b = c0 (2 + (gamma - 1)/2 ((rho_a + rho_b)/rho0 - 2)),
/// off by 3e-4 of itself where the density is off by 1 %. Over all pairs it would act like a kinematic viscosity
/// alpha h c0/(2 (d + 2)) in a continuum; approaching pairs alone are half of them: 0.46 of it in shear and 0.54 in
/// strain on a lattice, 0.46 off it, with the Gaussian and h = 1.23 dx in 2D (docs/theory.md has the others).
/// Cao et al. 2014, Eq. 1.
struct ArtificialViscosity
{
    static constexpr std::string_view name = "artificial";
    static constexpr std::string_view sentence =
        "Monaghan's artificial viscosity with coefficient alpha, for approaching particles";

    double alpha = 0; ///< dimensionless
    double c0 = 0;    ///< [m/s]
    double rho0 = 0;  ///< [kg/m^3]
    double gamma = 7;
    static constexpr std::array<Coefficient<ArtificialViscosity>, 1> coefficients{
        {{{.name = "alpha",
           .leftOut = "by scheme: recommended 0.02, cao2014 0.03",
           .example = "0.03",
           .range = notNegative,
           .sentence = "acts like about half of nu = alpha h c0/(2 (d + 2)) in d dimensions, as only approaching pairs "
                       "contribute: docs/theory.md"},
          &ArtificialViscosity::alpha}}};

    static ArtificialViscosity of(const TaitEquation& state, double alpha = 0)
    {
        return {alpha, state.c0, state.rho0, state.gamma};
    }
    /// Over all pairs: where all around a particle close in, all count.
    double kinematic(int dim, double h, double) const { return alpha * h * c0 / (2.0 * (dim + 2)); }

    template <class S>
    LineViscosity<S> inLoop(int, double) const
    {
        // (c_a + c_b)/(rho_a + rho_b) = constant s_a s_b/(s_a + s_b) + linear
        return {
            static_cast<RealOf<S>>(-alpha * c0 * (3 - gamma)),
            static_cast<RealOf<S>>(-alpha * c0 * (gamma - 1) / (2 * rho0)), 1};
    }
};

} // namespace slosh
