// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>

namespace slosh
{

/// The largest step an explicit weakly compressible step may take, [s]:
///   dt = min(maxCo h/(c0 + max |v|), 0.25 sqrt(h/max |dv/dt|), h^2/(8 nu))
/// the acoustic, the acceleration and the viscous limit (Monaghan 1992; Morris, Fox & Zhu 1997). maxCo counts smoothing
/// lengths a sound wave crosses in a step.
inline double
stableTimeStep(double maxCo, double smoothingLength, double c0, double maxSpeed, double maxAcceleration, double nu)
{
    const double acoustic = maxCo * smoothingLength / (c0 + maxSpeed);
    const double viscous = smoothingLength * smoothingLength / (8 * nu);            // infinite without viscosity
    const double accelerated = 0.25 * std::sqrt(smoothingLength / maxAcceleration); // infinite at rest
    return std::min({acoustic, viscous, accelerated});
}

} // namespace slosh
