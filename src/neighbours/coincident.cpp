// SPDX-License-Identifier: GPL-3.0-or-later
#include "neighbours/coincident.hpp"

#include "neighbours/CellGrid.hpp"

#include <span>

namespace slosh
{

std::optional<std::pair<std::size_t, std::size_t>> coincident(const Particles& particles, double distance)
{
    const std::ptrdiff_t n = particles.nFluid;
    CellGrid grid;
    grid.build(std::span(particles.r).first(n), particles.spacing);
    for (std::size_t i = 0; i < n; ++i)
    {
        std::size_t other = n;
        grid.forEachNear(particles.r[i], distance,
                         [&](int k)
                         {
                             const auto j = static_cast<std::size_t>(k);
                             if (j > i && j < other && (particles.r[i] - particles.r[j]).norm() < distance)
                             {
                                 other = j;
                             }
                         });
        if (other < n)
        {
            return std::pair(i, other);
        }
    }
    return std::nullopt;
}

} // namespace slosh
