// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/Tank.hpp"
#include "motion/SolverFrame.hpp"
#include "motion/Wrench.hpp"
#include "particles/Particles.hpp"

#include <vector>

namespace slosh
{

/// The load of the liquid on the tank, from the balance of its momentum: forces of liquid on liquid cancel, so with the
/// accelerations a and the body force b
///   F = -sum m (a - b),   M = -sum (r - c) x m (a - b),
/// about the tank's origin c, along the inertial axes, [N], [N m]; in 2D times the slice's thickness. What
/// sampling/loadOnTank.hpp sums over walls. `gravity`: in the inertial frame.
Wrench loadByMomentum(
    const Particles& particles, const std::vector<Vec>& acceleration, const SolverFrame& frame, const Vec& gravity,
    const Tank& tank
);

} // namespace slosh
