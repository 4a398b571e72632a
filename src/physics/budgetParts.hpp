// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "physics/Pair.hpp"

namespace slosh
{

/// The parts that the energy budget distinguishes in the equations of a particle a, with the factors of Momentum and
/// Continuity:
///   viscous        = sum_b Pi_ab F_ab r_ab/h, of liquid b alone where walls slip,
///   wallGradient   = sum_w (p_a/rho_a^2 + p_w/rho_w^2) F_aw r_aw/h,
///   wallDivergence = sum_w (1/rho_w) F_aw v_aw . r_aw/h, w the walls.
template <int dim, class Viscosity, class S>
struct BudgetParts
{
    Viscosity Pi;
    bool wallsSlip;
    std::array<S, dim> viscous{}, wallGradient{};
    S wallDivergence = S(0);

    void add(const Pair<dim, S>& pair, const S& F)
    {
        const S approach = pair.approach();
        wallDivergence += pair.ofWalls(approach * (pair.b.s() * F));
        const S walls = pair.ofWalls(pair.a.P() + pair.b.P()) * F;
        const S dissipation = pair.ofLiquidAlone(wallsSlip, Pi(pair, approach)) * F;
        for (std::size_t d = 0; d < dim; ++d)
        {
            wallGradient[d] += walls * pair.x[d];
            viscous[d] += dissipation * pair.x[d];
        }
    }
};

} // namespace slosh
