#include "integration/stopAtWalls.hpp"

#include "base/parallel.hpp"

#include <functional>

namespace slosh
{

long stopAtWalls(const Tank& tank, Frame frame, const RigidState& tankState, Particles& particles)
{
    const bool inTank = frame == Frame::tank;
    return parallelReduce(
        particles.nFluid, 0L,
        [&](std::ptrdiff_t begin, std::ptrdiff_t end)
        {
            long stopped = 0;
            for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i)
            {
                const Vec& r = particles.r[i];
                const Vec X = inTank ? r : tankState.pointToTank(r);
                if (tank.isInside(X))
                {
                    continue;
                }
                const NearestSurface wall = tank.nearestWall(X);
                const Vec n = inTank ? wall.normal : Vec(tankState.R * wall.normal);
                const Vec relative = inTank ? particles.v[i] : Vec(particles.v[i] - tankState.velocityAt(X));
                if (const double away = relative.dot(n); away < 0)
                {
                    particles.v[i] -= away * n;
                    ++stopped;
                }
            }
            return stopped;
        },
        std::plus<>());
}

} // namespace slosh
