#pragma once

#include "base/parallel.hpp"
#include "motion/BodyForce.hpp"
#include "particles/Particles.hpp"
#include "physics/interact.hpp"

#include <algorithm>
#include <array>

namespace slosh
{

/// The pressure a wall particle takes from the liquid around it, Adami et al. 2012; Cao et al. 2014, Eq. 13:
///   p_w = sum_f (p_f + rho_f (g - a_w) . r_wf) W_wf / sum_f W_wf
/// for the walls in reach of liquid; the others keep p = 0. With `suction` off a wall does not pull: p_w is at least 0,
/// and at least as high as the liquid's mean pressure is low, p_w >= max(0, -sum_f p_f W_wf / sum_f W_wf), so that p_f
/// + p_w repels or vanishes. A weakly compressible liquid knows no cavitation: walls that pull at liquid about to leave
/// draw particles into themselves (leakage; docs/decisions/0005-walls-do-not-pull.md).
template <int dim, class Kernel, class S>
void wallPressure(const PairRecords<RealOf<S>>& records, const NeighbourList& neighbours, const BodyForce& bodyForce,
                  double smoothingLength, bool suction, Particles& particles)
{
    const auto& walls = neighbours.wallsInReach();
    parallelBlocks(static_cast<std::ptrdiff_t>(walls.size()), 128,
                   [&](std::ptrdiff_t begin, std::ptrdiff_t end)
                   {
                       for (std::ptrdiff_t k = begin; k < end; ++k)
                       {
                           const std::ptrdiff_t w = walls[static_cast<std::size_t>(k)];
                           S sumW(0), sumP(0);
                           std::array<S, dim> sumRho{}; // rho_f r_wf/h
                           interact<dim, S>(records, w, neighbours.row(w),
                                            [&](const Pair<dim, S>& pair)
                                            {
                                                const S W = Kernel::f(pair.q2);
                                                const S rho = 1 / pair.b.s();
                                                const S rhoW = rho * W;
                                                sumW += W;
                                                sumP += pair.b.P() * rho * rhoW;
                                                for (std::size_t d = 0; d < dim; ++d)
                                                {
                                                    sumRho[d] += rhoW * pair.x[d];
                                                }
                                            });
                           const auto i = static_cast<std::size_t>(w);
                           const Vec b = bodyForce.atWall(particles.r[i]);
                           const double liquid = laneSum(sumP);
                           double p = liquid;
                           for (int d = 0; d < dim; ++d)
                           {
                               p += smoothingLength * b[records.direction(d)] *
                                    static_cast<double>(laneSum(sumRho[static_cast<std::size_t>(d)]));
                           }
                           // In the list but outside the support: no liquid to feel.
                           const double W = laneSum(sumW);
                           p = W > 0 ? p / W : 0;
                           particles.p[i] = suction ? p : std::max({p, 0.0, W > 0 ? -liquid / W : 0});
                       }
                   });
}

} // namespace slosh
