// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "motion/BodyForce.hpp"
#include "motion/RigidState.hpp"

namespace slosh
{

/// The frame positions and velocities are given in (DESIGN section 6).
enum class Frame
{
    tank,
    inertial
};

/// As dictionaries and time directories name it.
inline const char* nameOf(Frame frame)
{
    return frame == Frame::tank ? "tank" : "inertial";
}

/// The place in the tank of a point r of that frame.
inline Vec pointInTank(const Vec& r, Frame frame, const RigidState& tank)
{
    return frame == Frame::tank ? r : tank.pointToTank(r);
}

/// The same, back: where the point X of the tank is in that frame.
inline Vec pointFromTank(const Vec& X, Frame frame, const RigidState& tank)
{
    return frame == Frame::tank ? X : tank.pointToInertial(X);
}

/// The components along the tank's axes of a vector of that frame: R^T u from the inertial one.
inline Vec alongTankAxes(const Vec& u, Frame frame, const RigidState& tank)
{
    return frame == Frame::tank ? u : Vec(tank.R.transpose() * u);
}

/// The same, back: along the axes of that frame.
inline Vec fromTankAxes(const Vec& U, Frame frame, const RigidState& tank)
{
    return frame == Frame::tank ? U : Vec(tank.R * U);
}

/// The body force in that frame.
inline BodyForce bodyForceIn(Frame frame, const Vec& gravity, const RigidState& tank)
{
    return frame == Frame::tank ? BodyForce::inTankFrame(gravity, tank) : BodyForce::inInertialFrame(gravity, tank);
}

} // namespace slosh
