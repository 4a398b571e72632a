// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "physics/Pair.hpp"
#include "physics/PairTerms.hpp"

namespace slosh
{

/// The pairs' part of the momentum equation of a particle a, Cao et al. 2014, Eq. 1:
///   sum_b (p_a/rho_a^2 + p_b/rho_b^2 + Pi_ab) F_ab r_ab/h,   F = (1/q) df/dq: times -m alpha/h^(dim+1) it is dv_a/dt
/// over liquid and walls b; Pi, the viscosity, of liquid alone where walls slip.
template <int dim, class Viscosity, class S>
struct Momentum
{
    Viscosity Pi;
    bool wallsSlip;
    std::array<S, dim> gradient{};

    /// `Pi`: the loop's form of terms.viscosity.
    static Momentum of(const PairTerms& terms, const Viscosity& Pi) { return {Pi, terms.wallsSlip, {}}; }

    void add(const Pair<dim, S>& pair, const S& F)
    {
        const auto viscous = Pi(pair, pair.approach());
        const S pressure = (pair.a.P() + pair.b.P() + pair.ofLiquidAlone(wallsSlip, viscous)) * F;
        for (std::size_t d = 0; d < dim; ++d)
        {
            gradient[d] += pressure * pair.x[d];
        }
    }
};

} // namespace slosh
