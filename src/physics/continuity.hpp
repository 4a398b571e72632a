// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "physics/Pair.hpp"

#include <type_traits>

namespace slosh
{

/// The continuity equation of a particle a, Cao et al. 2014, Eq. 1, and its density diffusion:
///   divergence = sum_b (1/rho_b) F_ab v_ab . r_ab/h,   diffusion = sum_b (1/rho_b) F_ab D_ab,
/// both times rho_a m alpha/h^(dim+1); D_ab of liquid alone (physics/FourtakasDensityDiffusion.hpp says why).
template <int dim, class Diffusion, class S>
struct Continuity
{
    static constexpr bool diffuses =
        !std::is_same_v<decltype(std::declval<Diffusion>()(std::declval<const Pair<dim, S>&>())), Zero>;
    Diffusion D;
    S divergence = S(0);
    S diffusion = S(0);

    void add(const Pair<dim, S>& pair, const S& F)
    {
        const S sF = pair.b.s() * F;
        divergence += pair.approach() * sF;
        if constexpr (diffuses)
        {
            diffusion += pair.ofLiquid(D(pair)) * sF;
        }
    }
};

} // namespace slosh
