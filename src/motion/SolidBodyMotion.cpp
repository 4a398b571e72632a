// SPDX-License-Identifier: GPL-3.0-or-later
#include "motion/SolidBodyMotion.hpp"

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
