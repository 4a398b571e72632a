// SPDX-License-Identifier: GPL-3.0-or-later
#include "particles/changeFrame.hpp"

namespace slosh
{

void changeFrame(Particles& particles, const RigidState& tank, Frame from, Frame to)
{
    if (from == to)
    {
        return;
    }
    for (std::size_t i = 0; i < particles.r.size(); ++i)
    {
        Vec& r = particles.r[i];
        Vec& v = particles.v[i];
        if (to == Frame::inertial)
        {
            v = tank.velocityAt(r) + tank.R * v;
            r = tank.pointToInertial(r);
        }
        else
        {
            r = tank.pointToTank(r);
            v = tank.R.transpose() * (v - tank.velocityAt(r));
        }
    }
}

} // namespace slosh
