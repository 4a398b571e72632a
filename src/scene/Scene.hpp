// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "case/Case.hpp"
#include "fluid/FluidProperties.hpp"
#include "fluid/TaitEquation.hpp"
#include "geometry/Tank.hpp"
#include "kernels/Kernel.hpp"
#include "motion/SolidBodyMotion.hpp"
#include "viscosities/ViscosityChoice.hpp"

#include <memory>

namespace slosh
{

/// What a case's constant/ says, read once, with two entries of system/: what the equations are solved for, and what
/// never changes during a run. All programs work on it.
struct Scene
{
    Tank tank;
    Kernel kernel;
    std::shared_ptr<const SolidBodyMotion> motion;
    Vec gravity; ///< in the inertial frame, [m/s^2]
    TaitEquation equationOfState;
    FluidProperties fluid{};
    ViscosityChoice viscosity{};
    double particleSpacing = 0; ///< [m]
    /// Whether a wall may pull, see physics/wallState.hpp: wall { type Adami; suction no; } of system/sphSchemes,
    /// the one entry from there, which samples need, too.
    bool wallSuction = false;
    /// What `speedOfSound auto` is, whether or not it is taken, [m/s]; 0: not known.
    double automaticSpeedOfSound = 0;

    /// `particleSpacing`: as the particles' time directory has it, or as blockParticles is asked for. Throws CaseError.
    static Scene read(const Case& theCase, double particleSpacing);

    /// The same with its kernel for another spacing.
    Scene withSpacing(double particleSpacing) const;
    /// The same in a tank at rest, where it stands under `g` (along the tank's axes).
    Scene atRest(const Vec& g) const;
};

/// wall { } of system/sphSchemes.
Key wallKey();
/// `particleSpacing` of system/blockParticlesDict, what it is before there are particles.
Key particleSpacingKey();
/// `liquidAtRest` of system/blockParticlesDict, on which the automatic speed of sound depends.
Key liquidAtRestKey();

} // namespace slosh
