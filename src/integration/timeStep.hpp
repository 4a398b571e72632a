#pragma once

#include <algorithm>
#include <cmath>

namespace slosh
{

/// The largest c0 dt/h at which the predictor-corrector is stable with the paper's kernel and viscosity, alpha = 0.03,
/// as measured; 0.42 with the cubic spline (docs/stability.md). maxCo = 0.25, the default, keeps well below.
constexpr double largestStableCo = 0.65;

/// The largest step an explicit weakly compressible step may take, [s]:
///   dt = min(maxCo h/(c0 + max |v|), 0.25 sqrt(h/max |dv/dt|))
/// the acoustic and the acceleration limit (Monaghan 1992). maxCo counts smoothing lengths a sound wave crosses in a
/// step.
inline double stableTimeStep(double maxCo, double smoothingLength, double c0, double maxSpeed, double maxAcceleration)
{
    const double acoustic = maxCo * smoothingLength / (c0 + maxSpeed);
    return maxAcceleration > 0 ? std::min(acoustic, 0.25 * std::sqrt(smoothingLength / maxAcceleration)) : acoustic;
}

/// The largest step at which an explicit step damps with a kinematic viscosity nu > 0, 0.125 h^2/nu, [s] (Morris, Fox &
/// Zhu 1997). An artificial viscosity alpha acts like nu = alpha h c0/(2(d + 2)): in 2D h/(alpha c0), longer than the
/// acoustic step unless alpha > 4.
inline double viscousTimeStep(double smoothingLength, double nu)
{
    return 0.125 * smoothingLength * smoothingLength / nu;
}

} // namespace slosh
