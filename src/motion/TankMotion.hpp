// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "motion/RigidState.hpp"
#include "motion/Wrench.hpp"

namespace slosh
{

/// A step of the tank's motion.
struct TankStep
{
    RigidState over; ///< as the step feels it, SolidBodyMotion::over
    RigidState end;
};

/// What moves the tank during a run: its state is advanced step by step. A prescribed motion takes it from its law and
/// asks for no load.
class TankMotion
{
public:
    virtual ~TankMotion() = default;

    /// The step from `begin`, where the tank is as `now` says, to `end`, [s], to be accepted or dropped; of no length
    /// where they are equal. `load`: of the liquid on the tank, about the tank's origin, along the inertial axes,
    /// without what was stopped at walls.
    virtual TankStep advance(const RigidState& now, double begin, double end, const Wrench& load) const = 0;
    /// Whether the load moves it: else none is summed.
    virtual bool isMovedByLoad() const { return false; }
};

} // namespace slosh
