// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "fluid/TaitEquation.hpp"
#include "motion/SolverFrame.hpp"
#include "particles/Particles.hpp"

namespace slosh
{

/// Energies of the liquid, [J]; in 2D times the slice's thickness.
struct LiquidEnergies
{
    double kineticInTank = 0; ///< of the motion relative to the tank, sum m V^2/2
    double kinetic = 0;       ///< in the inertial frame, sum m v^2/2
    double potential = 0;     ///< -sum m g . x, zero at the world's origin
    double internal = 0;      ///< of compression, sum m int_rho0^rho p/rho^2 drho

    double total() const { return kinetic + potential + internal; } ///< in the inertial frame
};

/// `frame`: of the particles; gravity in the inertial one.
LiquidEnergies liquidEnergies(
    const Particles& particles, const TaitEquation& equationOfState, const Vec& gravity, const SolverFrame& frame,
    double thickness
);

/// Its internal energy alone.
double internalEnergy(const Particles& particles, const TaitEquation& equationOfState, double thickness);

} // namespace slosh
