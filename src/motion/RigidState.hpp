// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Vec.hpp"

namespace slosh
{

/// Where the tank is and how it moves at one instant. A point X of the tank (tank coordinates = world coordinates of
/// the tank before it moves) stands at
///     x = c + R X,   v = c' + omega x (R X),   a = c'' + omega' x (R X) + omega x (omega x (R X)),
/// all vectors in the inertial frame, SI units, angles in rad.
struct RigidState
{
    Vec c = Vec::Zero();            ///< displacement of the tank's origin, [m]
    Vec velocity = Vec::Zero();     ///< c', [m/s]
    Vec acceleration = Vec::Zero(); ///< c'', [m/s^2]
    Mat R = Mat::Identity();        ///< rotation, tank -> inertial
    Vec omega = Vec::Zero();        ///< angular velocity, [rad/s]
    Vec omegaDot = Vec::Zero();     ///< angular acceleration, [rad/s^2]

    Vec pointToInertial(const Vec& X) const { return c + R * X; }
    Vec pointToTank(const Vec& x) const { return R.transpose() * (x - c); }
    Vec velocityAt(const Vec& X) const { return velocity + omega.cross(R * X); }
    Vec accelerationAt(const Vec& X) const
    {
        const Vec s = R * X;
        return acceleration + omegaDot.cross(s) + omega.cross(omega.cross(s));
    }
};

} // namespace slosh
