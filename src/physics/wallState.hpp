// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Vec.hpp"
#include "base/unrolled.hpp"
#include "physics/Pair.hpp"

#include <algorithm>

namespace slosh
{

/// What a wall particle w sees of the liquid f around it.
struct LiquidAtWall
{
    double W = 0;                  ///< sum_f W_wf, or of what is proportional to it
    double p = 0;                  ///< sum_f p_f W_wf
    Vec towardsWall = Vec::Zero(); ///< sum_f rho_f r_wf W_wf, r in units of `length`
    Vec v = Vec::Zero();           ///< sum_f v_f W_wf
    double length = 1;             ///< [m]
};

/// What it shows to the liquid.
struct WallState
{
    double p = 0; ///< [Pa]
    Vec velocity = Vec::Zero();
};

/// The pressure a wall particle takes from the liquid around it, Adami et al. 2012; Cao et al. 2014, Eq. 13:
///   p_w = sum_f (p_f + rho_f (g - a_w) . r_wf) W_wf / sum_f W_wf.
/// Where it may not pull, p_w is at least what makes the mean of p_f + p_w vanish, p_w >= -sum_f p_f W_wf / sum_f W_wf.
/// A weakly compressible liquid knows no cavitation: walls that pull at liquid about to leave draw particles into
/// themselves (leakage; docs/decisions/0005-walls-do-not-pull.md).
///
/// The velocity that the liquid meets there is the wall's own, v_w, but where the wall has nothing to push and the
/// liquid leaves,
///   v_w + min((v_f - v_w) . n, 0) n,   v_f = sum_f v_f W_wf / sum_f W_wf,   n along sum_f rho_f r_wf W_wf, to the
///   wall:
/// such a wall must not stretch the liquid, whose density would fall and whose tension would do work that no force has
/// put in (docs/decisions/0014-liquid-leaves-walls.md).
///
/// `b`: g - a_w. Without liquid in reach p_w = 0.
inline WallState wallState(const LiquidAtWall& seen, const Vec& v, const Vec& b, bool mayPull)
{
    WallState wall{0, v};
    if (!(seen.W > 0))
    {
        return wall;
    }
    const double liquid = seen.p / seen.W;
    const double p = liquid + seen.length * b.dot(seen.towardsWall) / seen.W;
    const double least = -liquid; // p_f + p_w repels or vanishes, in the mean
    wall.p = mayPull ? p : std::max(p, least);
    if (!mayPull && p <= least)
    {
        const Vec n = seen.towardsWall.normalized();
        wall.velocity += std::min((seen.v / seen.W - v).dot(n), 0.0) * n;
    }
    return wall;
}

/// What a liquid particle a gives to the sums of LiquidAtWall of walls w around it, r_wa in units of h and W = f(q)
/// alpha/h^dim without its factor.
template <int dim, class Kernel, class S>
struct WallSums
{
    static constexpr std::size_t W = 0, p = 1, towardsWall = 2, v = 2 + dim, numbers = 2 + 2 * dim;
    static constexpr bool ofWalls = true;

    template <class Pair, class SumsA, class SumsW>
    [[gnu::always_inline]] void add(const Pair& pair, const SumsA&, const SumsW& w) const
    {
        const S f = Kernel::f(pair.q2);
        const S rho = 1 / pair.a.s;
        const S rhoW = rho * f;
        w.add(W, f);
        w.addProduct(p, pair.a.P * rho, rhoW);
        unrolled<dim>([&](auto d) __attribute__((always_inline)) {
            w.subtractProduct(towardsWall + d, rhoW, pair.x[d]);
            w.addProduct(v + d, f, pair.a.v[d]);
        });
    }
};

} // namespace slosh
