#pragma once

#include <algorithm>
#include <cmath>

namespace slosh
{

/// The largest step an explicit weakly compressible step may take, [s]:
///   dt = min(maxCo h/(c0 + max |v|), 0.25 sqrt(h/max |dv/dt|))
/// the acoustic and the acceleration limit (Monaghan 1992). maxCo counts smoothing lengths a sound wave crosses in a
/// step.
inline double stableTimeStep(double maxCo, double smoothingLength, double c0, double maxSpeed, double maxAcceleration)
{
    const double acoustic = maxCo * smoothingLength / (c0 + maxSpeed);
    return maxAcceleration > 0 ? std::min(acoustic, 0.25 * std::sqrt(smoothingLength / maxAcceleration)) : acoustic;
}

} // namespace slosh
