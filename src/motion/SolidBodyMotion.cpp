// SPDX-License-Identifier: GPL-3.0-or-later
#include "motion/SolidBodyMotion.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace slosh
{

namespace
{

class Stationary final : public SolidBodyMotion
{
public:
    RigidState at(double) const override { return {}; }
    std::string description() const override { return "stationary"; }
    bool isStationary() const override { return true; }
};

} // namespace

double SolidBodyMotion::lastTime() const
{
    return std::numeric_limits<double>::infinity();
}

double SolidBodyMotion::greatestSpeed(const BoundingBox& box, double end, int parts, bool liquidRestsInTank) const
{
    if (isStationary())
    {
        return 0;
    }
    const Vec X0 = box.center();
    const Vec U =
        liquidRestsInTank ? Vec((at(end).pointToInertial(X0) - at(0).pointToInertial(X0)) / end) : Vec(Vec::Zero());
    double atStart = 0, speed = 0, acceleration = 0;
    for (int n = 0; n <= parts; ++n)
    {
        const RigidState state = at(end * n / parts);
        for (int corner = 0; corner < 8; ++corner)
        {
            const Vec X = box.corner(static_cast<BoundingBox::CornerType>(corner));
            speed = std::max(speed, (state.velocityAt(X) - U).norm());
            acceleration = std::max(acceleration, state.accelerationAt(X).norm());
        }
        if (n == 0 && !liquidRestsInTank)
        {
            atStart = speed;
        }
    }
    return std::max(atStart, std::min(speed, std::sqrt(acceleration * box.sizes().maxCoeff())));
}

std::unique_ptr<SolidBodyMotion> SolidBodyMotion::stationary()
{
    return std::make_unique<Stationary>();
}

RigidState SolidBodyMotion::over(double begin, double end) const
{
    if (begin == end || isStationary())
    {
        return at(begin);
    }
    const RigidState first = at(begin), last = at(end);
    RigidState mean = at((begin + end) / 2);
    mean.velocity = (first.velocity + last.velocity) / 2;
    mean.omega = (first.omega + last.omega) / 2;
    mean.acceleration = (last.velocity - first.velocity) / (end - begin);
    mean.omegaDot = (last.omega - first.omega) / (end - begin);
    return mean;
}

} // namespace slosh
