// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace slosh
{

/// Where the liquid's energy has come from and gone to since `since`, [J], in the inertial frame: what is left of
///     E - initial = work - (viscosity + densityDiffusion + walls + reinitialisation + stops),
/// E = kinetic + potential + internal, is the residual. Each term is a sum of its own over the steps, none the rest of
/// the others (solver/EnergyAccount.hpp). What is taken from the liquid counts positive.
struct EnergyBudget
{
    double since = 0;            ///< the instant all sums begin at, [s]
    double initial = 0;          ///< E then
    double work = 0;             ///< done by the tank, int F . V + M . omega dt
    double positiveWork = 0;     ///< the same, while it is positive: what was put in, with nothing taken out again
    double viscosity = 0;        ///< artificial, laminar or of the Riemann solver; at walls too; the damper of sound
    double densityDiffusion = 0; ///< fall of the internal energy by the density diffusion
    double walls =
        0; ///< work of the pressure between liquid and wall particles that the liquid's density does not keep
    double reinitialisation = 0; ///< fall of the internal energy at re-initialisations of the density
    double stops = 0;            ///< where particles were stopped at walls (integration/stopAtWalls.hpp)

    double taken() const { return viscosity + densityDiffusion + walls + reinitialisation + stops; }
    double residual(double energy) const { return energy - initial - work + taken(); }
};

} // namespace slosh
