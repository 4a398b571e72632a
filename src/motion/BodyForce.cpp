// SPDX-License-Identifier: GPL-3.0-or-later
#include "motion/BodyForce.hpp"

namespace slosh
{

BodyForce BodyForce::inTankFrame(const Vec& gravity, const RigidState& tank)
{
    const Mat toTank = tank.R.transpose();
    const Vec uniform = toTank * (gravity - tank.acceleration);
    return {true, uniform, uniform, Vec::Zero(), toTank * tank.omega, toTank * tank.omegaDot};
}

BodyForce BodyForce::inInertialFrame(const Vec& gravity, const RigidState& tank)
{
    return {false, gravity, gravity - tank.acceleration, tank.c, tank.omega, tank.omegaDot};
}

} // namespace slosh
