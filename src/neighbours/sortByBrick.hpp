// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "neighbours/Clusters.hpp"
#include "particles/Particles.hpp"

namespace slosh
{

/// The edge of the bricks of `particles` in `dim` dimensions whose support has radius R: whole cells of edge R, so many
/// that a brick full of liquid holds about a sixteenth of it, 64 particles at least, so that threads have equal shares,
/// and no more than 600 in 2D, 1700 in 3D, so that what it works on stays in a processor's own cache
/// (docs/performance.md).
double brickEdge(const Particles& particles, int dim, double supportRadius);

/// Brings the liquid into the order of its clusters (neighbours/Clusters.hpp), which it returns, and notes its bricks
/// (Particles::bricks). Walls keep their order.
Clusters sortByBrick(Particles& particles, double brickEdge);

} // namespace slosh
