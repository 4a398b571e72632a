// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/loadByMomentum.hpp"

#include "particles/reduce.hpp"
#include "physics/bodyForceIn.hpp"

#include <functional>

namespace slosh
{

Wrench loadByMomentum(
    const Particles& particles, const std::vector<Vec>& acceleration, const SolverFrame& frame, const Vec& gravity,
    const Tank& tank
)
{
    const BodyForce bodyForce = bodyForceIn(frame, gravity);
    const Vec origin = frame.fromTank(Vec::Zero());
    const int empty = tank.emptyDirection();
    const Wrench sum = reduceLiquid(
        particles, Wrench(),
        [&](std::ptrdiff_t begin, std::ptrdiff_t end)
        {
            Wrench part;
            for (std::ptrdiff_t i = begin; i < end; ++i)
            {
                const Vec f = -accelerationByContact(particles, acceleration, bodyForce, empty, i);
                part += Wrench{f, (particles.r[i] - origin).cross(f)};
            }
            return part;
        },
        std::plus<>()
    );
    const double mass = particles.mass * tank.thickness();
    return {mass * frame.alongInertial(sum.force), mass * frame.alongInertial(sum.moment)};
}

} // namespace slosh
