// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Zero.hpp"
#include "base/unrolled.hpp"
#include "physics/Pair.hpp"
#include "physics/PairTerms.hpp"

namespace slosh
{

/// The pairs' part of the momentum equation of a particle a, Cao et al. 2014, Eq. 1:
///   sum_b (p_a/rho_a^2 + p_b/rho_b^2 + Pi_ab) F_ab r_ab/h,   F = (1/q) df/dq: times -m alpha/h^(dim+1) it is dv_a/dt
/// over liquid and walls b; Pi, the viscosity, of liquid alone where walls slip. What a takes, b gives.
template <int dim, class Viscosity, class S>
struct Momentum
{
    static constexpr std::size_t gradient = 0, numbers = dim;
    Viscosity Pi;
    bool wallsSlip;

    /// `Pi`: the loop's form of terms.viscosity.
    static Momentum of(const PairTerms& terms, const Viscosity& Pi) { return {Pi, terms.wallsSlip}; }

    template <class Pair, class SumsA, class SumsB>
    [[gnu::always_inline]] void add(const Pair& pair, const S& F, const SumsA& a, const SumsB& b) const
    {
        S pressure = pair.a.P + pair.b.P;
        if (!Pair::withWall || !wallsSlip)
        {
            pressure = pressure + Pi(pair, pair.approach);
        }
        pressure *= F;
        unrolled<dim>([&](auto d) __attribute__((always_inline)) {
            a.addProduct(gradient + d, pressure, pair.x[d]);
            b.subtractProduct(gradient + d, pressure, pair.x[d]);
        });
    }
};

} // namespace slosh
