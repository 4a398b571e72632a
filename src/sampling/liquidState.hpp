// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "sampling/Snapshot.hpp"

namespace slosh
{

/// Sums over the liquid; its energies are particles/liquidEnergies.hpp.
struct LiquidState
{
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
