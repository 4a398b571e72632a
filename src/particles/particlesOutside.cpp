// SPDX-License-Identifier: GPL-3.0-or-later
#include "particles/particlesOutside.hpp"

#include "particles/reduce.hpp"

namespace slosh
{

std::vector<std::ptrdiff_t> particlesOutside(const Tank& tank, const Particles& particles, const SolverFrame& frame)
{
    using Indices = std::vector<std::ptrdiff_t>;
    return reduceLiquid(
        particles, Indices{},
        [&](std::ptrdiff_t begin, std::ptrdiff_t end)
        {
            Indices outside;
            for (std::ptrdiff_t i = begin; i < end; ++i)
            {
                const Vec X = frame.toTank(particles.r[i]);
                // A position that is not a number is outside.
                if (!tank.isInside(X) && !(tank.distanceToWall(X) >= -particles.spacing / 2))
                {
                    outside.push_back(i);
                }
            }
            return outside;
        },
        [](Indices a, const Indices& b)
        {
            a.insert(a.end(), b.begin(), b.end());
            return a;
        }
    );
}

} // namespace slosh
