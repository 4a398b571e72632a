// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "physics/Viscosity.hpp"

#include <variant>

namespace slosh
{

/// Any of them, asked for at each pair: for loops whose speed does not matter.
template <class S>
struct AnyViscosity
{
    std::variant<NoViscosity::InLoop<S>, LineViscosity<S>, LowDissipationRiemann::InLoop<S>> Pi;

    template <int dim>
    S operator()(const Pair<dim, S>& pair, const S& approach) const
    {
        if (const auto* line = std::get_if<LineViscosity<S>>(&Pi))
        {
            return (*line)(pair, approach);
        }
        const auto* riemann = std::get_if<LowDissipationRiemann::InLoop<S>>(&Pi);
        return riemann == nullptr ? S(0) : (*riemann)(pair, approach);
    }

    static AnyViscosity of(const ViscosityChoice& choice, int dim)
    {
        return std::visit(
            [&](const auto& viscosity) { return AnyViscosity{viscosity.template inLoop<S>(dim)}; }, choice
        );
    }
};

} // namespace slosh
