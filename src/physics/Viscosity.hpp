#pragma once

#include "particles/FluidProperties.hpp"
#include "physics/ArtificialViscosity.hpp"
#include "physics/NoViscosity.hpp"

#include <variant>

namespace slosh
{

/// What adds to the pressure of a pair; each is a type with `name` and inLoop<S>(): (pair, approach) -> Pi_ab.
using ViscosityChoice = std::variant<NoViscosity, ArtificialViscosity>;

/// What constant/fluidProperties asks for.
inline ViscosityChoice chooseViscosity(const FluidProperties& fluid, const TaitEquation& state)
{
    if (fluid.viscosity == FluidProperties::Viscosity::none)
    {
        return NoViscosity{};
    }
    return ArtificialViscosity{fluid.alpha, state.c0, state.rho0, state.gamma};
}

} // namespace slosh
