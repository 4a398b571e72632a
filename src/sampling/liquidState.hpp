#pragma once

#include "sampling/Snapshot.hpp"

namespace slosh
{

/// Sums over the liquid; in 2D times the slice's thickness.
struct LiquidState
{
    double kinetic = 0;             ///< of the motion relative to the tank, sum m V^2/2, [J]
    double kineticInertial = 0;     ///< sum m v^2/2, [J]
    double potential = 0;           ///< -sum m g . x, zero at the world's origin, [J]
    double internal = 0;            ///< of compression, sum m int_rho0^rho p/rho^2 drho, [J]
    Vec centreInTank = Vec::Zero(); ///< centre of mass, [m]
    Vec centre = Vec::Zero();       ///< the same in the inertial frame, [m]
    Vec velocity = Vec::Zero();     ///< of the centre of mass in the inertial frame, [m/s]
    double largestDeviation = 0;    ///< max |rho/rho0 - 1|
    double rmsDeviation = 0;        ///< root of the mean of (rho/rho0 - 1)^2
    Vec semiAxes = Vec::Zero(); ///< of the ellipse or ellipsoid that the liquid would be if it were one, in the tank,
                                ///< [m]: a_d = sqrt((dim + 2) <(X_d - <X_d>)^2>)
    BoundingBox extent;         ///< of the particles' cells in the tank, half a spacing beyond their centres, [m]
};

LiquidState liquidState(const Snapshot& snapshot);

} // namespace slosh
