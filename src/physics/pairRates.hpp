// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/parallel.hpp"
#include "particles/Particles.hpp"
#include "physics/BodyForce.hpp"
#include "physics/FourtakasDensityDiffusion.hpp"
#include "physics/NoDensityDiffusion.hpp"
#include "physics/Rates.hpp"
#include "physics/interact.hpp"

#include <array>
#include <cmath>
#include <type_traits>

namespace slosh
{

/// The right-hand sides of Cao et al. 2014, Eq. 1, for every liquid particle a, sums over liquid and wall particles b
/// of mass m:
///   drho_a/dt = rho_a m sum_b (1/rho_b) (v_a - v_b) . grad_a W_ab + D_a - <D_a>
///   D_a       = rho_a m sum_b (1/rho_b) D_ab . grad_a W_ab                     D_ab: density diffusion, <D_a> its mean
///   dv_a/dt   = b_a - m sum_b (p_a/rho_a^2 + p_b/rho_b^2 + Pi_ab) grad_a W_ab  Pi_ab: viscosity
/// grad_a W_ab = alpha/h^(dim+1) dfByQ(q^2) r_ab/h: the factor in front is applied once per particle. b: the body force
/// (gravity and the frame's), without its component in the empty direction. Wanted::dissipation: D_ab and Pi_ab alone;
/// Wanted::walls: b a wall particle alone, for NoViscosity and NoDensityDiffusion.
///
/// Along walls that slip (`wallsSlip`) Pi_ab is left out of the pairs with wall particles, so that they take no stress,
/// as the free surface does. D_ab is left out of them always: see FourtakasDensityDiffusion.hpp.
template <int dim, class Kernel, class S, Wanted wanted, class Viscosity, class DensityDiffusion>
void pairRates(const PairRecords<RealOf<S>>& records, const NeighbourList& neighbours, const Particles& particles,
               double smoothingLength, const BodyForce& bodyForce, const Viscosity& viscosity, bool wallsSlip,
               const DensityDiffusion& densityDiffusion, Rates& rates)
{
    constexpr bool wantsAcceleration = wanted != Wanted::densityRate;
    constexpr bool wantsDensityRate = wanted != Wanted::acceleration;
    constexpr bool dissipationAlone = wanted == Wanted::dissipation;
    constexpr bool wallsAlone = wanted == Wanted::walls;
    constexpr bool isAll = !dissipationAlone && !wallsAlone;
    constexpr bool diffuses = !std::is_same_v<DensityDiffusion, NoDensityDiffusion>;
    const auto Pi = viscosity.template inLoop<S>();
    const double factor = particles.mass * Kernel::alpha(dim) / std::pow(smoothingLength, dim + 1);
    const auto meanDiffusion = particles.values<double>(FourtakasDensityDiffusion::meanField);
    const std::ptrdiff_t liquid = recordOf(particles.nFluid); // the walls' records begin here
    const std::ptrdiff_t viscousPartners = wallsSlip ? liquid : recordOf(particles.size());

    parallelBlocks(
        particles.nFluid, particlesABlock, [&](std::ptrdiff_t begin, std::ptrdiff_t end) __attribute__((flatten)) {
            for (std::ptrdiff_t a = begin; a < end; ++a)
            {
                const std::ptrdiff_t i = a;
                const auto s_a = static_cast<double>(records.of(a)[slotS]);
                const auto D =
                    densityDiffusion.template around<dim, S>(records, smoothingLength, bodyForce, particles.r[i], s_a);
                S divergence(0);
                S diffusion(0);
                std::array<S, dim> gradient{};
                interact<dim, S>(records, a, neighbours.row(a),
                                 [&](const Pair<dim, S>& pair)
                                 {
                                     const S F = Kernel::dfByQ(pair.q2);
                                     const S approach = pair.approach();
                                     const auto ofWalls = [&](const S& x)
                                     { return wallsAlone ? x - pair.whereBefore(liquid, x) : x; };
                                     if constexpr (wantsDensityRate)
                                     {
                                         const S sF = pair.b.s() * F;
                                         if constexpr (!dissipationAlone)
                                         {
                                             divergence += ofWalls(approach * sF);
                                         }
                                         if constexpr (diffuses)
                                         {
                                             diffusion += pair.whereBefore(liquid, D(pair)) * sF;
                                         }
                                     }
                                     if constexpr (wantsAcceleration)
                                     {
                                         const S mean = dissipationAlone ? S(0) : ofWalls(pair.a.P() + pair.b.P());
                                         const S pressure =
                                             (mean + pair.whereBefore(viscousPartners, Pi(pair, approach))) * F;
                                         for (std::size_t d = 0; d < dim; ++d)
                                         {
                                             gradient[d] += pressure * pair.x[d];
                                         }
                                     }
                                 });
                if constexpr (wantsDensityRate)
                {
                    rates.densityRate[i] = factor * laneSum(divergence) * particles.rho[i];
                    if constexpr (diffuses)
                    {
                        rates.diffusion[i] = factor * laneSum(diffusion) * particles.rho[i];
                        rates.densityRate[i] += rates.diffusion[i] - (meanDiffusion.empty() ? 0 : meanDiffusion[i]);
                    }
                }
                if constexpr (wantsAcceleration)
                {
                    const Vec b = isAll ? bodyForce.onLiquid(particles.r[i], particles.v[i]) : Vec(Vec::Zero());
                    rates.acceleration[i].setZero();
                    for (int d = 0; d < dim; ++d)
                    {
                        const int k = records.direction(d);
                        rates.acceleration[i][k] = b[k] - factor * laneSum(gradient[d]);
                    }
                }
            }
        });
}

} // namespace slosh
