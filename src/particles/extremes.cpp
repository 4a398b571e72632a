// SPDX-License-Identifier: GPL-3.0-or-later
#include "particles/extremes.hpp"

#include "particles/reduce.hpp"

#include <cmath>

namespace slosh
{

Extremes extremes(const Particles& particles, double rho0)
{
    Extremes found = reduceLiquid( // of the speed its square
        particles, Extremes{},
        [&](std::ptrdiff_t begin, std::ptrdiff_t end)
        {
            Extremes e;
            for (std::ptrdiff_t i = begin; i < end; ++i)
            {
                e.speed = larger(e.speed, particles.v[i].squaredNorm());
                e.densityDeviation = larger(e.densityDeviation, std::abs(particles.rho[i] / rho0 - 1));
            }
            return e;
        },
        [&](const Extremes& a, const Extremes& b) {
            return Extremes{larger(a.speed, b.speed), larger(a.densityDeviation, b.densityDeviation)};
        }
    );
    found.speed = std::sqrt(found.speed);
    return found;
}

} // namespace slosh
