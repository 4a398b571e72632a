// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "motion/Wrench.hpp"
#include "sampling/Snapshot.hpp"

#include <vector>

namespace slosh
{

/// What the liquid does to the tank.
struct Load
{
    Wrench pressure;
    Wrench viscous; ///< of whatever viscosity there is: the artificial one and the Riemann solver's are most in impacts

    Wrench total() const { return pressure + viscous; }
    Load operator+(const Load& other) const { return {pressure + other.pressure, viscous + other.viscous}; }
};

/// The reaction to what the walls do to the liquid in Eq. 1, by parts of the tank as Tank::partNames() has them,
///   F = sum_w m sum_f m (p_f/rho_f^2 + p_w/rho_w^2 + Pi_fw) grad_f W_fw
/// over the wall particles nearest to each, Pi_fw the viscosity between liquid and wall (viscosities/; none where it
/// slips), and what friction takes from the liquid nearest to it (physics/WallFriction.hpp), acting at the liquid
/// particles; in tank axes (tankAxes) or in inertial ones, moments about CofR (tank coordinates). In 2D times the
/// slice's thickness. In double precision, from positions, velocities, pressures and densities alone. What stops a
/// particle that has come behind a wall (integration/stopAtWalls.hpp) is no force and not in it: TimeState::stops has
/// it.
std::vector<Load> loadsOnParts(const Snapshot& snapshot, const Vec& CofR, bool tankAxes);

} // namespace slosh
