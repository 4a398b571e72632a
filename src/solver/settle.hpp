// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/WeaklyCompressible.hpp"

namespace slosh
{

/// What settle() did.
struct Settled
{
    long steps = 0;
    double moved = 0;      ///< farthest a particle has moved, [m]
    double speedLeft = 0;  ///< max |v| at the end, [m/s]
    double speedOnWay = 0; ///< the largest max |v|, [m/s]
};

/// Lets the liquid come to rest in the tank as it stands at the start, before it moves: a lattice with the pressure of
/// a still column is not quite in equilibrium with itself, its surface and its walls, and what it lacks, some
/// hundredths of a spacing, becomes waves when the run starts (docs/decisions/0015-liquid-settles-first.md). Solves
/// `scene` for `time` [s] with a tank at rest under `gravity` (in the tank) and the artificial viscosity alpha = 1.
/// Positions, densities and pressures of `particles` are then those of the settled liquid, velocities as they were.
/// Throws UnphysicalRun.
Settled settle(const Scene& scene, const Schemes& schemes, const Vec& gravity, double time, Particles& particles);

} // namespace slosh
