// SPDX-License-Identifier: GPL-3.0-or-later
#include "motion/SolidBodyMotion.hpp"

#include <algorithm>
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

double SolidBodyMotion::greatestSpeed(const BoundingBox& box, double end, int parts) const
{
    double speed = 0;
    for (int n = 0; n <= parts && !isStationary(); ++n)
    {
        const RigidState state = at(end * n / parts);
        for (int corner = 0; corner < 8; ++corner)
        {
            const Vec X = box.corner(static_cast<BoundingBox::CornerType>(corner));
            speed = std::max(speed, state.velocityAt(X).norm());
        }
    }
    return speed;
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
