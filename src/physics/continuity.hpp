// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Zero.hpp"
#include "physics/Pair.hpp"

#include <type_traits>

namespace slosh
{

/// The continuity equation of a particle a, Cao et al. 2014, Eq. 1, and its density diffusion:
///   divergence = sum_b (1/rho_b) F_ab v_ab . r_ab/h,   diffusion = sum_b (1/rho_b) F_ab D_ab,
/// both times rho_a m alpha/h^(dim+1); D_ab = -D_ba of liquid alone (physics/FourtakasDensityDiffusion.hpp says why).
template <int dim, class Diffusion, class S>
struct Continuity
{
    static constexpr bool diffuses =
        !std::is_same_v<decltype(std::declval<Diffusion>()(std::declval<const Pair<dim, S, false>&>())), Zero>;
    static constexpr std::size_t divergence = 0, diffusion = 1, numbers = diffuses ? 2 : 1;
    Diffusion D;

    template <class Pair, class SumsA, class SumsB>
    [[gnu::always_inline]] void add(const Pair& pair, const S& F, const SumsA& a, const SumsB& b) const
    {
        const S flow = pair.approach * F;
        a.addProduct(divergence, pair.b.s, flow);
        b.addProduct(divergence, pair.a.s, flow);
        if constexpr (diffuses && !Pair::withWall)
        {
            const S exchange = D(pair) * F;
            a.addProduct(diffusion, pair.b.s, exchange);
            b.subtractProduct(diffusion, pair.a.s, exchange);
        }
    }
};

} // namespace slosh
