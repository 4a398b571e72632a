// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/parallel.hpp"
#include "particles/Particles.hpp"
#include "physics/BodyForce.hpp"
#include "physics/WallContact.hpp"
#include "physics/interact.hpp"

#include <algorithm>
#include <array>
#include <vector>

namespace slosh
{

/// The pressure a wall particle takes from the liquid around it, Adami et al. 2012; Cao et al. 2014, Eq. 13:
///   p_w = sum_f (p_f + rho_f (g - a_w) . r_wf) W_wf / sum_f W_wf
/// for the walls in reach of liquid; the others keep p = 0. With `suction` off a wall does not pull: p_w is at least
/// what makes the mean of p_f + p_w vanish, p_w >= -sum_f p_f W_wf / sum_f W_wf. A weakly compressible liquid knows no
/// cavitation: walls that pull at liquid about to leave draw particles into themselves (leakage;
/// docs/decisions/0005-walls-do-not-pull.md).
///
/// `shown`, like particles.v: the velocity that the liquid meets at these walls. It is the wall's own, v_w, but where
/// the wall has nothing to push and the liquid leaves,
///   v_w + min((v_f - v_w) . n, 0) n,   v_f = sum_f v_f W_wf / sum_f W_wf,   n along sum_f rho_f r_wf W_wf, to the
///   wall:
/// such a wall must not stretch the liquid, whose density would fall and whose tension would do work that no force has
/// put in (docs/decisions/0014-liquid-leaves-walls.md).
///
/// `contact`: by wall particle, from 0 at the first; filled for the walls in reach where it is not empty. Walls that
/// are `enclosed` in it may pull.
template <int dim, class Kernel, class S>
void wallPressure(const PairRecords<RealOf<S>>& records, const NeighbourList& neighbours, const BodyForce& bodyForce,
                  double smoothingLength, bool suction, Particles& particles, std::vector<Vec>& shown,
                  std::vector<WallContact>& contact)
{
    const double shareOfW = Kernel::alpha(dim) * std::pow(particles.spacing / smoothingLength, dim);
    const auto vectorOf = [&records](const std::array<S, dim>& sums)
    {
        Vec x = Vec::Zero();
        for (int d = 0; d < dim; ++d)
        {
            x[records.direction(d)] = static_cast<double>(laneSum(sums[d]));
        }
        return x;
    };
    const auto& walls = neighbours.wallsInReach();
    parallelBlocks(
        static_cast<std::ptrdiff_t>(walls.size()),
        particlesABlock, [&](std::ptrdiff_t begin, std::ptrdiff_t end) __attribute__((flatten)) {
            for (std::ptrdiff_t k = begin; k < end; ++k)
            {
                const std::ptrdiff_t w = walls[k];
                S sumW(0), sumP(0);
                std::array<S, dim> sumRho{}; // rho_f r_wf/h
                std::array<S, dim> sumV{};
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
                                         sumV[d] += W * pair.b.v(static_cast<int>(d));
                                     }
                                 });
                const std::ptrdiff_t i = w;
                shown[i] = particles.v[i];
                const double W = laneSum(sumW);
                bool mayPull = suction;
                if (!contact.empty())
                {
                    WallContact& seen = contact[i - particles.nFluid];
                    seen.share = shareOfW * W;
                    seen.velocity = W > 0 ? Vec(vectorOf(sumV) / W) : particles.v[i];
                    seen.away =
                        W > 0 ? Vec(vectorOf(sumRho) * (-smoothingLength / (particles.rho[i] * W))) : Vec::Zero();
                    mayPull = mayPull || seen.enclosed;
                }
                if (!(W > 0)) // in the list but outside the support: no liquid to feel
                {
                    particles.p[i] = 0;
                    continue;
                }
                const double liquid = laneSum(sumP) / W;
                const Vec towardsWall = vectorOf(sumRho);
                const double p = liquid + smoothingLength * bodyForce.atWall(particles.r[i]).dot(towardsWall) / W;
                const double least = -liquid; // p_f + p_w repels or vanishes, in the mean
                particles.p[i] = mayPull ? p : std::max(p, least);
                if (!mayPull && p <= least)
                {
                    const Vec n = towardsWall.normalized();
                    shown[i] += std::min((vectorOf(sumV) / W - particles.v[i]).dot(n), 0.0) * n;
                }
            }
        });
}

} // namespace slosh
