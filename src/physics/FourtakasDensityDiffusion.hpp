// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/unrolled.hpp"
#include "particles/Field.hpp"
#include "physics/BodyForce.hpp"
#include "physics/Pair.hpp"

#include <array>
#include <cmath>
#include <string_view>

namespace slosh
{

/// Density diffusion that leaves liquid at rest alone, Fourtakas et al. 2019 (Computers & Fluids 190, 346), with the
/// body force b on liquid at rest in it, so that "at rest" holds in a tank that moves as well, and in a form that keeps
/// the liquid's volume: adds to drho_a/dt
///   delta h c0 sum_b (rho0/rho_b) V_b psi_ab . grad_a W_ab,   psi_ab = 2 rho_a rho_b (s_a - s_b - s^H_ab)
///   r_ba/|r_ab|^2,
/// over liquid particles b, s = 1/rho; s^H_ab is the difference between a and b in liquid at rest, by the midpoint rule
/// from ds/dr = -s b/c^2, c^2 = c0^2 (rho/rho0)^(gamma - 1), Tait's. In the terms of the pair loop psi_ab . grad_a W_ab
/// has no quotient: it is -2 (...) (1/r) dW/dr.
///
/// s^H_ab = -s^H_ba (to third order in s_a - s_b). A pair is evaluated once, from its a: what it gives a in volume, m
/// ds_a/dt, it takes from b, and sum m/rho does not change. This is why walls are left out (physics/continuity.hpp): a
/// wall particle has no volume to take from. For the same reason b is taken half-way between a and b: of its part
/// linear in r only the centrifugal force counts,
///   b(r_a - r_ab/2) . r_ab = b(r_a) . r_ab - |omega x r_ab|^2/2.
/// What is left of it at rest is not zero. At a free surface Eq. 1 is in balance with densities a little off Tait's
/// column, which this term works against for ever: it carries density from the surface into the depth, the depth
/// expands, the surface's own sum, of half a support, does not see that it should shrink, and the level rises. So the
/// equations take D_a less its mean over the last thousand steps or so,
///   d<D_a>/dt = (D_a - <D_a>)/T,   T = 1000 h/c0; in the case's first T the time since its start, at least T/10:
/// nothing of a steady state, all of sound and noise; <D_a> is 0 without liquid in reach (docs/decisions/0026).
/// Without s^H it is that of Molteni & Colagrossi 2009, which lets a free surface rise for ever.
struct FourtakasDensityDiffusion
{
    static constexpr std::string_view name = "Fourtakas";

    /// <D_a>, the state that goes from step to step, [kg/m^3/s].
    static constexpr const char* meanField = "meanDiffusion";
    static Field mean() { return {meanField, ParticleRange::liquid, std::vector<double>()}; }

    /// T, [s]
    static double memory(double smoothingLength, double c0) { return 1000 * smoothingLength / c0; }

    double delta = 0; ///< dimensionless, usually 0.1
    double c0 = 0;    ///< [m/s]
    double rho0 = 0;  ///< [kg/m^3]
    double gamma = 7;

    template <int dim, class S>
    struct AroundParticle
    {
        RealOf<S> strength;                ///< -2 delta c0 rho0, [kg/m^2/s]
        std::array<PerRow<S>, dim> slope;  ///< s_a h b/c_a^2, [m^3/kg]
        PerRow<S> halfCurvature;           ///< d ln(s/c^2)/ds/2 at a, [kg/m^3]
        PerRow<S> minusSpin2;              ///< -s_a h^2 |omega|^2/(2 c_a^2), [m^3/kg]
        std::array<PerRow<S>, dim> spin{}; ///< omega along the scene's directions, of the same scale: sqrt of [m^3/kg]

        /// What is added to v_ab . r_ab/h, [m/s].
        template <class Pair>
        [[gnu::always_inline]] S operator()(const Pair& pair) const
        {
            const S difference = pair.a.s - pair.b.s;
            S atRest = broadcast<S>(minusSpin2) * pair.q2;
            unrolled<dim>([&](auto d) __attribute__((always_inline)) {
                atRest = multiplyAdd(broadcast<S>(slope[d]), pair.x[d], atRest);
            });
            if constexpr (dim == 3) // in 2D the tank turns about the empty direction
            {
                S along = broadcast<S>(0);
                unrolled<dim>([&](auto d) __attribute__((always_inline)) {
                    along = multiplyAdd(broadcast<S>(spin[d]), pair.x[d], along);
                });
                atRest = multiplyAdd(along, along, atRest);
            }
            const S curved = subtractProduct(broadcast<S>(halfCurvature), difference, broadcast<S>(1));
            return broadcast<S>(strength) * multiplyAdd(atRest, curved, difference);
        }
    };

    /// Of the particles at r with the densities rho, one in each row of S. `directions`: the components of Vec that are
    /// not empty. delta = 0: none.
    template <int dim, class S>
    AroundParticle<dim, S> around(
        const std::array<int, 3>& directions, double smoothingLength, const BodyForce& bodyForce,
        const std::array<Vec, rowsOf<S>>& r, const std::array<double, rowsOf<S>>& rho
    ) const
    {
        AroundParticle<dim, S> terms{};
        if (delta == 0)
        {
            return terms;
        }
        using Real = RealOf<S>;
        const double h = smoothingLength;
        terms.strength = static_cast<Real>(-2 * delta * c0 * rho0);
        for (std::size_t row = 0; row < rho.size(); ++row)
        {
            const Vec b = bodyForce.onRestingLiquid(r[row]);
            const double ratio = rho[row] * (1 / rho0), x = ratio - 1;
            const double c2 = c0 * c0 * (1 + (gamma - 1) * x * (1 + (gamma - 2) * x / 2));
            const double minusDc2 = c0 * c0 * (gamma - 1) * (1 + (gamma - 2) * x) * ratio * rho[row]; // -dc^2/ds
            const double sByC2 = 1 / (rho[row] * c2); // the only division: it is as dear as some pairs
            terms.halfCurvature[row] = static_cast<Real>((rho[row] + minusDc2 * rho[row] * sByC2) / 2);
            for (int d = 0; d < dim; ++d)
            {
                terms.slope[d][row] = static_cast<Real>(h * sByC2 * b[directions[d]]);
            }
            if (bodyForce.rotates)
            {
                const Vec& omega = bodyForce.omega;
                const double scale = h * std::sqrt(sByC2 / 2);
                terms.minusSpin2[row] = static_cast<Real>(-(scale * scale * omega.squaredNorm()));
                for (int d = 0; d < dim; ++d)
                {
                    terms.spin[d][row] = static_cast<Real>(scale * omega[directions[d]]);
                }
            }
        }
        return terms;
    }
};

} // namespace slosh
