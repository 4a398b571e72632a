// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/Tank.hpp"
#include "motion/SolverFrame.hpp"
#include "motion/Wrench.hpp"
#include "particles/Particles.hpp"
#include "physics/BodyForce.hpp"

#include <vector>

namespace slosh
{

/// a - b of particle i, [m/s^2]: of its acceleration a what is not the body force b. `emptyDirection`: of the tank.
inline Vec accelerationByContact(
    const Particles& particles, const std::vector<Vec>& acceleration, const BodyForce& bodyForce, int emptyDirection,
    std::ptrdiff_t i
)
{
    Vec a = acceleration[i] - bodyForce.onLiquid(particles.r[i], particles.v[i]);
    if (emptyDirection >= 0)
    {
        a[emptyDirection] = 0;
    }
    return a;
}

/// The load of the liquid on the tank, from the balance of its momentum: forces of liquid on liquid cancel, so with the
/// accelerations a and the body force b
///   F = -sum m (a - b),   M = -sum (r - c) x m (a - b),
/// about the tank's origin c, along the inertial axes, [N], [N m]; in 2D times the slice's thickness. What
/// sampling/loadsOnParts.hpp sums over walls. `gravity`: in the inertial frame.
Wrench loadByMomentum(
    const Particles& particles, const std::vector<Vec>& acceleration, const SolverFrame& frame, const Vec& gravity,
    const Tank& tank
);

} // namespace slosh
