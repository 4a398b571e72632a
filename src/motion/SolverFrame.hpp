// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "motion/RigidState.hpp"

#include <string_view>

namespace slosh
{

/// The frame positions and velocities are given in: that of the tank or the inertial one.
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

inline Frame frameNamed(std::string_view name)
{
    return name == "tank" ? Frame::tank : Frame::inertial;
}

/// A frame at an instant at which the tank stands and moves as `tank` says: what of it is where, and how it moves. r, v
/// and u are a position, a velocity and a free vector of this frame, X and U of the tank's.
class SolverFrame
{
public:
    SolverFrame(Frame frame, const RigidState& tank) : isTanks_(frame == Frame::tank), tank_(tank) {}

    Frame frame() const { return isTanks_ ? Frame::tank : Frame::inertial; }
    const RigidState& tank() const { return tank_; }
    /// Walls stand where they are in the tank, at rest.
    bool wallsRest() const { return isTanks_; }

    // Places: X of the tank, r here, x in the inertial frame.
    Vec toTank(const Vec& r) const { return isTanks_ ? r : tank_.pointToTank(r); }
    Vec fromTank(const Vec& X) const { return isTanks_ ? X : tank_.pointToInertial(X); }
    Vec toInertial(const Vec& r) const { return isTanks_ ? tank_.pointToInertial(r) : r; }

    // Components along the axes of the tank, of this frame, of the inertial one.
    Vec alongTank(const Vec& u) const { return isTanks_ ? u : Vec(tank_.R.transpose() * u); }
    Vec fromTankAxes(const Vec& U) const { return isTanks_ ? U : Vec(tank_.R * U); }
    Vec alongInertial(const Vec& u) const { return isTanks_ ? Vec(tank_.R * u) : u; }
    Vec fromInertialAxes(const Vec& u) const { return isTanks_ ? Vec(tank_.R.transpose() * u) : u; }

    /// The velocity of the tank's point that is at r, in the inertial frame, along the axes of this one.
    Vec carried(const Vec& r) const { return fromInertialAxes(tank_.velocityAt(toTank(r))); }
    /// The same, seen in this frame: of the tank none.
    Vec wallVelocity(const Vec& X) const { return isTanks_ ? Vec(Vec::Zero()) : tank_.velocityAt(X); }
    /// v less that of the tank there, along the axes of this frame.
    Vec relative(const Vec& v, const Vec& r) const { return isTanks_ ? v : Vec(v - tank_.velocityAt(toTank(r))); }
    /// v in the inertial frame and along its axes.
    Vec absolute(const Vec& v, const Vec& r) const { return isTanks_ ? Vec(tank_.velocityAt(r) + tank_.R * v) : v; }
    /// How the tank turns, seen in this frame, [rad/s].
    Vec spin() const { return isTanks_ ? Vec(Vec::Zero()) : tank_.omega; }

private:
    bool isTanks_;
    RigidState tank_;
};

} // namespace slosh
