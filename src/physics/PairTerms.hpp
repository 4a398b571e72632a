// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "physics/DensityDiffusion.hpp"
#include "viscosities/ViscosityChoice.hpp"

namespace slosh
{

/// What a scene adds to the inviscid equations, per pair.
struct PairTerms
{
    ViscosityChoice viscosity;
    DensityDiffusionChoice densityDiffusion;
    bool wallsSlip = false; ///< viscosity acts within the liquid alone
};

} // namespace slosh
