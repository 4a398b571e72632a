// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "sampling/Snapshot.hpp"

namespace slosh
{

/// A force, [N], and its moment about a point of the tank, [N m].
struct Wrench
{
    Vec force = Vec::Zero();
    Vec moment = Vec::Zero();

    Wrench operator+(const Wrench& other) const { return {force + other.force, moment + other.moment}; }
};

/// What the liquid does to the tank.
struct Load
{
    Wrench pressure;
    Wrench viscous; ///< of whatever viscosity there is: the artificial one and the Riemann solver's are most in impacts

    Wrench total() const { return pressure + viscous; }
};

/// The reaction to what the walls do to the liquid in Eq. 1,
///   F = sum_w m sum_f m (p_f/rho_f^2 + p_w/rho_w^2 + Pi_fw) grad_f W_fw,
/// Pi_fw the viscosity between liquid and wall (physics/Viscosity.hpp; none where it slips), and what friction takes
/// from the liquid (physics/WallFriction.hpp), acting at the liquid particles, in tank axes
/// (tankAxes) or in inertial ones; moments about CofR (tank coordinates). In 2D times the slice's thickness. In double
/// precision, from positions, velocities, pressures and densities alone. What stops a particle that has come behind a
/// wall (integration/stopAtWalls.hpp) is no force and not in it.
Load loadOnTank(const Snapshot& snapshot, const Vec& CofR, bool tankAxes);

} // namespace slosh
