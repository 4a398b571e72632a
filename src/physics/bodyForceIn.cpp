// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/bodyForceIn.hpp"

namespace slosh
{

BodyForce bodyForceIn(const SolverFrame& frame, const Vec& g)
{
    const RigidState& tank = frame.tank();
    BodyForce force;
    force.fictitious = frame.frame() == Frame::tank;
    force.wallUniform = frame.fromInertialAxes(g - tank.acceleration);
    force.uniform = force.fictitious ? force.wallUniform : g;
    force.origin = frame.fromTank(Vec::Zero());
    force.omega = frame.fromInertialAxes(tank.omega);
    const Vec omegaDot = frame.fromInertialAxes(tank.omegaDot);
    for (int d = 0; d < 3; ++d)
    {
        const Vec axis = Vec::Unit(d);
        force.turning.col(d) = omegaDot.cross(axis) + force.omega.cross(force.omega.cross(axis));
    }
    force.rotates = !force.omega.isZero(0) || !omegaDot.isZero(0);
    return force;
}

} // namespace slosh
