// SPDX-License-Identifier: GPL-3.0-or-later
#include "particles/changeFrame.hpp"

#include "base/parallel.hpp"

namespace slosh
{

void changeFrame(Particles& particles, const SolverFrame& from, Frame to)
{
    if (from.frame() == to)
    {
        return;
    }
    const SolverFrame target(to, from.tank());
    parallelFor(
        particles.size(),
        [&](std::ptrdiff_t i)
        {
            Vec& r = particles.r[i];
            Vec& v = particles.v[i];
            const Vec relative = from.alongTank(from.relative(v, r)), X = from.toTank(r);
            r = target.fromTank(X);
            v = target.wallVelocity(X) + target.fromTankAxes(relative);
        }
    );
}

} // namespace slosh
