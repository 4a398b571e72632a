// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/scalarMath.hpp"
#include "fluid/TaitEquation.hpp"
#include "viscosities/Coefficient.hpp"

#include <array>
#include <string_view>

namespace slosh
{

/// The dissipation of a low-dissipation Riemann solver, Zhang, Hu & Adams 2017 (J. Comput. Phys. 335, 605): only where
/// particles close in fast. With U = max(-v_ab . e_ab, 0) the pressure between two particles is
///   p* = (p_a + p_b)/2 + rho c0 U min(eta U/c0, 1)/2,   eta = 3,
/// rho their mean density, so that Pi_ab = U min(eta U, c0) (1/rho_a + 1/rho_b)/2: second order in the closing speed
/// until that is c0/3. In a shear wave U sin(k y) it acts like a kinematic viscosity of about 0.14 h^2 k U, whatever c0
/// (improved Gaussian, h = 1.23 dx; docs/theory.md).
struct LowDissipationRiemann
{
    static constexpr std::string_view name = "lowDissipationRiemann";
    static constexpr std::string_view sentence =
        "Low-dissipation Riemann solver, for rapidly approaching particles; no parameters";
    static constexpr std::array<Coefficient<LowDissipationRiemann>, 0> coefficients{};

    static LowDissipationRiemann of(const TaitEquation& state) { return {state.c0}; }
    double kinematic(int, double, double) const { return 0; } ///< no limit of the step by it is known

    double c0 = 0; ///< [m/s]

    template <class S>
    struct InLoop
    {
        RealOf<S> c0;

        template <class Pair>
        S operator()(const Pair& pair, const S& approach) const
        {
            const S distance2 = pair.q2 + RealOf<S>(1e-12);
            const S closing = positivePart(-approach); // U q
            // U min(3 U, c0) = min(3 U^2, c0 U)
            const S squared = 3 * closing * closing / distance2;
            const S linear = c0 * closing / squareRoot(distance2);
            return (linear - positivePart(linear - squared)) * (pair.a.s + pair.b.s) / 2;
        }
    };

    template <class S>
    InLoop<S> inLoop(int, double) const
    {
        return {static_cast<RealOf<S>>(c0)};
    }
};

} // namespace slosh
