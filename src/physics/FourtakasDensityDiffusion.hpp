// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "motion/BodyForce.hpp"
#include "physics/interact.hpp"

#include <array>
#include <string_view>

namespace slosh
{

/// Density diffusion that leaves liquid at rest alone, Fourtakas et al. 2019 (Computers & Fluids 190, 346), with the
/// body force b on liquid at rest in it, so that "at rest" holds in a tank that moves as well: adds to drho_a/dt
///   delta h c0 sum_b V_b psi_ab . grad_a W_ab,   psi_ab = 2 (rho_b - rho_a - rho^H_ab) r_ba/|r_ab|^2,
///   rho^H_ab, the difference of density between a and b in liquid at rest: by the trapezoidal rule, from
///   ds/dr = -s b/c^2 at both ends, s = 1/rho, c^2 = c0^2 (rho/rho0)^(gamma - 1), Tait's, to second order.
/// With the slope of one end only, what is left is of second order, has the same sign all over the liquid and makes its
/// level sink for ever, by 0.1 mm in 8 s for delta = 0.02 and half a metre of water at c0 = 22 m/s. Without rho^H it is
/// that of Molteni & Colagrossi 2009, which lets a free surface rise for ever. In the terms of the
/// pair loop psi_ab . grad_a W_ab has no quotient: it is -2 (rho_b - rho_a - rho^H) (1/r) dW/dr.
struct FourtakasDensityDiffusion
{
    static constexpr std::string_view name = "Fourtakas";

    double delta = 0; ///< dimensionless, usually 0.1
    double c0 = 0;    ///< [m/s]
    double rho0 = 0;  ///< [kg/m^3]
    double gamma = 7;

    template <int dim, class S>
    struct AroundParticle
    {
        RealOf<S> minusTwoDeltaC;         ///< -2 delta c0, [m/s]
        std::array<RealOf<S>, dim> slope; ///< s_a h b/c_a^2, [m^3/kg]
        RealOf<S> halfCurvature;          ///< d ln(s/c^2)/ds/2 at a, [kg/m^3]

        /// What is added to (v_ab . r_ab/h)/rho_b, [m^4/kg/s]: V_b (rho_b - rho_a) = m rho_a (s_a - s_b).
        S operator()(const Pair<dim, S>& pair) const
        {
            const S difference = pair.a.s() - pair.b.s();
            S atRest = slope[0] * pair.x[0];
            for (std::size_t d = 1; d < dim; ++d)
            {
                atRest += slope[d] * pair.x[d];
            }
            return minusTwoDeltaC * (difference + atRest * (1 - halfCurvature * difference));
        }
    };

    /// Of the particle at r with the density 1/s.
    template <int dim, class S>
    AroundParticle<dim, S> around(const PairRecords<RealOf<S>>& records, double smoothingLength,
                                  const BodyForce& bodyForce, const Vec& r, double s) const
    {
        const Vec b = bodyForce.atWall(r);
        const double x = 1 / (s * rho0) - 1;
        const double c2 = c0 * c0 * (1 + (gamma - 1) * x * (1 + (gamma - 2) * x / 2));
        const double dc2 = -c0 * c0 * (gamma - 1) * (1 + (gamma - 2) * x) / (s * s * rho0); // dc^2/ds
        AroundParticle<dim, S> terms{
            static_cast<RealOf<S>>(-2 * delta * c0), {}, static_cast<RealOf<S>>((1 / s - dc2 / c2) / 2)};
        for (int d = 0; d < dim; ++d)
        {
            terms.slope[static_cast<std::size_t>(d)] =
                static_cast<RealOf<S>>(s * smoothingLength * b[records.direction(d)] / c2);
        }
        return terms;
    }
};

} // namespace slosh
