// SPDX-License-Identifier: GPL-3.0-or-later
#include "neighbours/coincident.hpp"

#include "neighbours/CellGrid.hpp"

#include <span>

namespace slosh
{

std::optional<std::pair<std::ptrdiff_t, std::ptrdiff_t>> coincident(const Particles& particles, double distance)
{
    const std::ptrdiff_t n = particles.nFluid;
    CellGrid grid;
    grid.build(std::span(particles.r).first(n), particles.spacing);
    for (std::ptrdiff_t i = 0; i < n; ++i)
    {
        std::ptrdiff_t other = n;
        grid.forEachNear(
            particles.r[i], distance,
            [&](int k)
            {
                const std::ptrdiff_t j = k;
                if (j > i && j < other && (particles.r[i] - particles.r[j]).norm() < distance)
                {
                    other = j;
                }
            }
        );
        if (other < n)
        {
            return std::pair(i, other);
        }
    }
    return std::nullopt;
}

} // namespace slosh
