// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "fluid/TaitEquation.hpp"
#include "physics/FourtakasDensityDiffusion.hpp"
#include "physics/NoDensityDiffusion.hpp"

#include <variant>

namespace slosh
{

/// What is added to the continuity equation per pair; each is a type with `name` and around<dim, S>(directions, h,
/// bodyForce, r_a, rho_a), the terms of one particle in each row of S: (pair) -> what is added to v_ab . r_ab/h.
using DensityDiffusionChoice = std::variant<NoDensityDiffusion, FourtakasDensityDiffusion>;

/// delta = 0: none.
inline DensityDiffusionChoice chooseDensityDiffusion(double delta, const TaitEquation& state)
{
    if (delta == 0)
    {
        return NoDensityDiffusion{};
    }
    return FourtakasDensityDiffusion{delta, state.c0, state.rho0, state.gamma};
}

} // namespace slosh
