// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "fluid/TaitEquation.hpp"
#include "geometry/Tank.hpp"
#include "motion/SolverFrame.hpp"
#include "motion/Wrench.hpp"
#include "particles/Particles.hpp"

#include <vector>

namespace slosh
{

/// What stopAtWalls() did, energies per unit mass of a particle, [m^2/s^2].
struct WallStops
{
    long behind = 0; ///< particles behind a wall's face, stopped or not; none is outside the tank where this is 0
    long particles = 0;
    double taken = 0; ///< sum u^2/2 + e(before) - e(after), e of compression: what such impacts dissipate, >= 0
    double work = 0;  ///< sum dv . v_wall: of the tank, in the inertial frame
    /// Impulse on each part of the tank, -sum dv, and its moment about the tank's origin, per unit mass of a particle,
    /// along the tank's axes; as NearestWall::part counts. Empty where nothing was stopped.
    std::vector<Wrench> onParts;
};

/// Takes from each liquid particle whose centre is behind the face of a wall the part of its velocity that goes into
/// it,
///     v <- v + u n,   u = max(-(v - v_wall) . n, 0),   n the wall's normal into the liquid,
/// and compresses it as liquid that is stopped at this speed, the water hammer of Joukowsky:
///     p <- max(p, rho0 c0 u).
/// Where p was 0 that is the energy which the impact takes, to first order in u/c0 and never more: such a stop is
/// nearly elastic. Liquid under tension, which no wall pushes, so comes off the face. Pressure keeps liquid at rest
/// half a spacing away; this is for single particles that it does not hold
/// (docs/decisions/0013-nothing-passes-a-wall.md).
WallStops
stopAtWalls(const Tank& tank, const SolverFrame& frame, const TaitEquation& equationOfState, Particles& particles);

/// Adds the impulses of `stops`, times a particle's mass, to those by part in `sum`; an empty one is zero.
void addImpulses(const WallStops& stops, double mass, std::vector<Wrench>& sum);

} // namespace slosh
