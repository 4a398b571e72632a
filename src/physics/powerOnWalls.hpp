// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/parallel.hpp"
#include "particles/Particles.hpp"
#include "physics/interact.hpp"

#include <array>
#include <cmath>

namespace slosh
{

/// The power that the pressure between liquid f and wall particles w takes from the liquid without its density keeping
/// it as internal energy, [W], in 2D [W/m]:
///   m^2 sum_w sum_f ((p_f/rho_f^2 + p_w/rho_w^2) (v_f - v_w)
///                    - (p_f/rho_f^2) (rho_f/rho_w) (v_f - v_shown)) . grad_f W_fw
/// the work of the pair's force in the wall's frame, less the internal energy that the pair's term of the continuity
/// equation gives the liquid. A wall particle has no energy of its own: what it takes while liquid comes nearer, m^2
/// p_w/rho_w^2 (v_f - v_w) . grad_f W_fw, it gives back when the liquid goes, if its pressure is the same then.
/// v_shown: see wallPressure.hpp; particles.v: the walls' own.
template <int dim, class Kernel, class S>
double powerOnWalls(const PairRecords<RealOf<S>>& records, const NeighbourList& neighbours, const Particles& particles,
                    double smoothingLength)
{
    const auto& walls = neighbours.wallsInReach();
    const double m = particles.mass;
    return m * m * Kernel::alpha(dim) / std::pow(smoothingLength, dim + 1) *
           parallelReduce(
               static_cast<std::ptrdiff_t>(walls.size()), 0.0,
               [&](std::ptrdiff_t begin, std::ptrdiff_t end) __attribute__((flatten)) {
                   double sum = 0;
                   for (std::ptrdiff_t k = begin; k < end; ++k)
                   {
                       const std::ptrdiff_t w = walls[static_cast<std::size_t>(k)];
                       const Vec& own = particles.v[static_cast<std::size_t>(w)];
                       std::array<RealOf<S>, dim> v;
                       for (int d = 0; d < dim; ++d)
                       {
                           v[static_cast<std::size_t>(d)] = static_cast<RealOf<S>>(own[records.direction(d)]);
                       }
                       S power(0);
                       interact<dim, S>(records, w, neighbours.row(w),
                                        [&](const Pair<dim, S>& pair)
                                        {
                                            // a: the wall, b: the liquid; v_ab . r_ab is the same for either order
                                            S approach(0);
                                            for (std::size_t d = 0; d < dim; ++d)
                                            {
                                                approach += (v[d] - pair.b.v(static_cast<int>(d))) * pair.x[d];
                                            }
                                            const S kept = pair.b.P() * pair.a.s() / pair.b.s() * pair.approach();
                                            power +=
                                                ((pair.a.P() + pair.b.P()) * approach - kept) * Kernel::dfByQ(pair.q2);
                                        });
                       sum += static_cast<double>(laneSum(power));
                   }
                   return sum;
               },
               [](double a, double b) { return a + b; });
}

} // namespace slosh
