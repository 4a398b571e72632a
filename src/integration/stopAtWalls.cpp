// SPDX-License-Identifier: GPL-3.0-or-later
#include "integration/stopAtWalls.hpp"

#include "base/parallel.hpp"

#include <algorithm>

namespace slosh
{

WallStops stopAtWalls(const Tank& tank, Frame frame, const RigidState& tankState, const TaitEquation& equationOfState,
                      Particles& particles)
{
    const bool inTank = frame == Frame::tank;
    return parallelReduce(
        particles.nFluid, WallStops{},
        [&](std::ptrdiff_t begin, std::ptrdiff_t end)
        {
            WallStops stopped;
            for (std::ptrdiff_t i = begin; i < end; ++i)
            {
                const Vec X = pointInTank(particles.r[i], frame, tankState);
                if (tank.isInside(X))
                {
                    continue;
                }
                ++stopped.behind;
                const NearestSurface wall = tank.nearestWall(X);
                const Vec n = fromTankAxes(wall.normal, frame, tankState);
                const Vec relative = inTank ? particles.v[i] : Vec(particles.v[i] - tankState.velocityAt(X));
                if (const double u = -relative.dot(n); u > 0)
                {
                    const double rho = std::max(particles.rho[i], equationOfState.rho(equationOfState.waterHammer(u)));
                    ++stopped.particles;
                    stopped.taken += u * u / 2 + equationOfState.energy(particles.rho[i]) - equationOfState.energy(rho);
                    stopped.work += u * (tankState.R * wall.normal).dot(tankState.velocityAt(X));
                    particles.v[i] += u * n;
                    particles.rho[i] = rho;
                }
            }
            return stopped;
        },
        [](const WallStops& a, const WallStops& b) {
            return WallStops{a.behind + b.behind, a.particles + b.particles, a.taken + b.taken, a.work + b.work};
        });
}

} // namespace slosh
