// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/LatticeField.hpp"
#include "sampling/Snapshot.hpp"

namespace slosh
{

/// volumeFraction() at the points of a lattice in tank coordinates, whose step along each direction divides the tank's
/// box evenly and is at most `step`, [m]: its outer points lie on the walls' faces, so that a surface F = 1/2 ends
/// there, and it is the same lattice at all times. Only the part within the kernel's support of the liquid's bounding
/// box is evaluated and kept: 4 bytes a point, on all threads. No points where there is no liquid.
LatticeField volumeFractionLattice(const Snapshot& snapshot, double step);

} // namespace slosh
