// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "fluid/FluidProperties.hpp"
#include "fluid/TaitEquation.hpp"
#include "geometry/Tank.hpp"
#include "kernels/Kernel.hpp"
#include "motion/SolidBodyMotion.hpp"

namespace slosh
{

/// What the equations are solved for: a liquid in a moving tank.
struct SloshingProblem
{
    const Tank& tank;
    const Kernel& kernel;
    const SolidBodyMotion& motion;
    Vec gravity;
    TaitEquation equationOfState;
    FluidProperties fluid; ///< its viscosity
};

} // namespace slosh
