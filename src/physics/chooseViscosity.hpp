// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "fluid/FluidProperties.hpp"
#include "physics/Viscosity.hpp"

namespace slosh
{

/// What constant/fluidProperties asks for; h: the smoothing length, [m].
inline ViscosityChoice chooseViscosity(const FluidProperties& fluid, const TaitEquation& state, double smoothingLength)
{
    switch (fluid.viscosity)
    {
    case FluidProperties::Viscosity::artificial:
        return ArtificialViscosity{fluid.alpha, state.c0, state.rho0, state.gamma};
    case FluidProperties::Viscosity::laminar:
        return LaminarViscosity{fluid.nu, smoothingLength};
    case FluidProperties::Viscosity::lowDissipationRiemann:
        return LowDissipationRiemann{state.c0};
    case FluidProperties::Viscosity::none:
        break;
    }
    return NoViscosity{};
}

} // namespace slosh
