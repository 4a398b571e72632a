// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "particles/Particles.hpp"
#include "scene/Scene.hpp"

namespace slosh
{

/// What startAbruptly() did.
struct AbruptStart
{
    long steps = 0;
    double energyBefore = 0, energyAfter = 0; ///< kinetic, relative to the tank, over the mass, [m^2/s^2]
};

/// The velocity of the liquid just after its tank has taken up a velocity at once. An incompressible liquid does so by
/// an impulse P, [Pa s],
///     u+ = u- - grad P/rho0,   div u+ = 0,   P = 0 at the surface,   n . u+ = n . U at the walls
/// (Batchelor 1967, section 6.10). Left to sound the same takes pressures of rho0 c0 U, which a wall that does not pull
/// cannot hold: the liquid leaves the bottom (docs/decisions/0030-abrupt-start.md).
///
/// `particles`: in the tank's frame, with the velocities u- - U; those of the liquid are u+ - U afterwards, nothing
/// else changes. The problem is linear, so that sound itself solves it: a jump of 1e-6 c0, without gravity, between
/// walls that pull; the mean velocity over some periods of the slowest sound is that of P.
AbruptStart startAbruptly(const Scene& scene, Particles& particles);

} // namespace slosh
