// SPDX-License-Identifier: GPL-3.0-or-later
#include "integration/stopAtWalls.hpp"

#include "particles/reduce.hpp"

#include <algorithm>

namespace slosh
{

namespace
{

WallStops operator+(const WallStops& a, const WallStops& b)
{
    WallStops sum{a.behind + b.behind, a.particles + b.particles, a.taken + b.taken, a.work + b.work, a.onParts};
    addImpulses(b, 1, sum.onParts);
    return sum;
}

} // namespace

WallStops
stopAtWalls(const Tank& tank, const SolverFrame& frame, const TaitEquation& equationOfState, Particles& particles)
{
    return reduceLiquid(
        particles, WallStops{},
        [&](std::ptrdiff_t begin, std::ptrdiff_t end)
        {
            WallStops stopped;
            for (std::ptrdiff_t i = begin; i < end; ++i)
            {
                const Vec X = frame.toTank(particles.r[i]);
                if (tank.isInside(X))
                {
                    continue;
                }
                ++stopped.behind;
                const NearestWall wall = tank.nearestWall(X);
                const Vec n = frame.fromTankAxes(wall.normal);
                const Vec relative = frame.relative(particles.v[i], particles.r[i]);
                if (const double u = -relative.dot(n); u > 0)
                {
                    const double rho = std::max(particles.rho[i], equationOfState.rho(equationOfState.waterHammer(u)));
                    ++stopped.particles;
                    stopped.taken += u * u / 2 + equationOfState.energy(particles.rho[i]) - equationOfState.energy(rho);
                    stopped.work += u * (frame.tank().R * wall.normal).dot(frame.tank().velocityAt(X));
                    stopped.onParts.resize(tank.parts());
                    stopped.onParts[wall.part] += Wrench{-u * wall.normal, X.cross(-u * wall.normal)};
                    particles.v[i] += u * n;
                    particles.rho[i] = rho;
                }
            }
            return stopped;
        },
        [](const WallStops& a, const WallStops& b) { return a + b; }
    );
}

void addImpulses(const WallStops& stops, double mass, std::vector<Wrench>& sum)
{
    sum.resize(std::max(sum.size(), stops.onParts.size()));
    for (std::size_t k = 0; k < stops.onParts.size(); ++k)
    {
        sum[k] += stops.onParts[k] * mass;
    }
}

} // namespace slosh
