#include "motion/BodyForce.hpp"

namespace slosh
{

BodyForce BodyForce::inTankFrame(const Vec& gravity, const RigidState& tank)
{
    BodyForce force;
    const Mat toTank = tank.R.transpose();
    force.tankFrame_ = true;
    force.uniform_ = toTank * (gravity - tank.acceleration);
    force.omega_ = toTank * tank.omega;
    force.omegaDot_ = toTank * tank.omegaDot;
    return force;
}

BodyForce BodyForce::inInertialFrame(const Vec& gravity, const RigidState& tank)
{
    BodyForce force;
    force.tankFrame_ = false;
    force.uniform_ = gravity;
    force.omega_ = tank.omega;
    force.omegaDot_ = tank.omegaDot;
    force.wallUniform_ = gravity - tank.acceleration;
    force.origin_ = tank.c;
    return force;
}

Vec BodyForce::onLiquid(const Vec& r, const Vec& v) const
{
    if (!tankFrame_)
    {
        return uniform_;
    }
    return uniform_ - omegaDot_.cross(r) - omega_.cross(omega_.cross(r)) - 2 * omega_.cross(v);
}

Vec BodyForce::atWall(const Vec& r) const
{
    if (tankFrame_)
    {
        return onLiquid(r, Vec::Zero());
    }
    const Vec s = r - origin_;
    return wallUniform_ - omegaDot_.cross(s) - omega_.cross(omega_.cross(s));
}

} // namespace slosh
