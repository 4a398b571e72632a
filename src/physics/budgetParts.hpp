// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/unrolled.hpp"
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
    static constexpr std::size_t viscous = 0, wallGradient = dim, wallDivergence = 2 * dim, numbers = 2 * dim + 1;
    Viscosity Pi;
    bool wallsSlip;

    template <class Pair, class SumsA, class SumsB>
    [[gnu::always_inline]] void add(const Pair& pair, const S& F, const SumsA& a, const SumsB& b) const
    {
        if constexpr (Pair::withWall)
        {
            a.addProduct(wallDivergence, pair.b.s, pair.approach * F);
            const S pressure = (pair.a.P + pair.b.P) * F;
            unrolled<dim>([&](auto d)
                              __attribute__((always_inline)) { a.addProduct(wallGradient + d, pressure, pair.x[d]); });
        }
        if (!Pair::withWall || !wallsSlip)
        {
            const S dissipation = Pi(pair, pair.approach) * F;
            unrolled<dim>([&](auto d) __attribute__((always_inline)) {
                a.addProduct(viscous + d, dissipation, pair.x[d]);
                b.subtractProduct(viscous + d, dissipation, pair.x[d]);
            });
        }
    }
};

} // namespace slosh
