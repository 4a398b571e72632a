// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "verification/LinearSloshing.hpp"

#include <utility>

namespace slosh
{

/// Sloshing in a box that sways along x and y at once, to first order: the sum of two plane solutions, which do not see
/// each other in the linear problem. Coordinates from the centre of the mean surface, z upwards, [m]. A square tank
/// moved along its diagonal with amplitude A has X = Y = A sin(omega t)/sqrt(2). Limits: those of LinearSloshing.
class BoxSloshing
{
public:
    /// `along x` has the tank's length along x, `along y` that along y; depth, g and rho are the same in both.
    BoxSloshing(LinearSloshing alongX, LinearSloshing alongY) : x_(std::move(alongX)), y_(std::move(alongY)) {}

    /// Elevation, [m].
    double eta(double x, double y, double t) { return x_.eta(x, t) + y_.eta(y, t); }
    /// Pressure, [Pa]; above the mean surface and in troughs as LinearSloshing says.
    double pressure(double x, double y, double z, double t)
    {
        return x_.pressure(x, z, t) + y_.pressure(y, z, t) + x_.tank().rho * x_.tank().g * z;
    }

private:
    LinearSloshing x_, y_;
};

} // namespace slosh
