// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/unrolled.hpp"
#include "physics/Pair.hpp"

#include <array>

namespace slosh
{

/// What a wall particle w sees of the liquid f around it; one in each lane of S.
template <int dim, class S>
struct LiquidAtWall
{
    using Vector = std::array<S, dim>;
    S W{};                ///< sum_f W_wf, or of what is proportional to it
    S p{};                ///< sum_f p_f W_wf
    Vector towardsWall{}; ///< sum_f rho_f r_wf W_wf, r in units of `length`
    Vector v{};           ///< sum_f v_f W_wf
    RealOf<S> length = 1; ///< [m]
};

/// What it shows to the liquid.
template <int dim, class S>
struct WallState
{
    S p; ///< [Pa]
    std::array<S, dim> velocity;
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
/// `b`: g - a_w. `mayPull`: > 0 where it may. Without liquid in reach p_w = 0.
template <int dim, class S>
WallState<dim, S> wallState(
    const LiquidAtWall<dim, S>& seen, const typename LiquidAtWall<dim, S>::Vector& v,
    const typename LiquidAtWall<dim, S>::Vector& b, const S& mayPull
)
{
    const S zero(0);
    const auto wet = seen.W > zero;
    const S perW = select(wet, 1 / select(wet, seen.W, S(1)), zero);
    const S liquid = seen.p * perW;
    const S p = liquid + seen.length * dot(b, seen.towardsWall) * perW;
    const S least = -liquid; // p_f + p_w repels or vanishes, in the mean
    const S pushing = select(mayPull > zero, p, select(p < least, least, p));

    // Along n, to the wall; 0 where it pushes or the liquid does not leave.
    const S length2 = dot(seen.towardsWall, seen.towardsWall);
    const S perLength = select(length2 > zero, 1 / squareRoot(select(length2 > zero, length2, S(1))), zero);
    S approach = zero;
    unrolled<dim>([&](auto d) { approach = approach + (seen.v[d] * perW - v[d]) * (seen.towardsWall[d] * perLength); });
    const S leaving = select(mayPull > zero, zero, select(p <= least, -positivePart(-approach), zero));

    WallState<dim, S> wall{select(wet, pushing, zero), v};
    unrolled<dim>([&](auto d)
                  { wall.velocity[d] = v[d] + select(wet, leaving, zero) * (seen.towardsWall[d] * perLength); });
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
