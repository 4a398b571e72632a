// SPDX-License-Identifier: GPL-3.0-or-later
#include "neighbours/sortByBrick.hpp"

#include "base/parallel.hpp"

#include <algorithm>
#include <cmath>
#include <span>

namespace slosh
{

double brickEdge(const Particles& particles, int dim, double supportRadius)
{
    const double wanted = std::clamp(static_cast<double>(particles.nFluid) / 16, 64.0, dim == 2 ? 600.0 : 1700.0);
    const double edge = std::pow(wanted, 1.0 / dim) * particles.spacing;
    return supportRadius * std::max(1.0, std::round(edge / supportRadius));
}

Clusters sortByBrick(Particles& particles, double brickEdge)
{
    const std::ptrdiff_t n = particles.nFluid;
    Clusters clusters;
    clusters.build(std::span<const Vec>(particles.r).first(n), std::span<const int>(particles.id).first(n), brickEdge);
    const std::vector<int>& order = clusters.order();
    particles.forEachField(
        [&](const auto&, ParticleRange range, auto& values)
        {
            if (range == ParticleRange::wall)
            {
                return;
            }
            auto sorted = values;
            parallelFor(n, [&](std::ptrdiff_t i) { sorted[i] = values[order[i]]; });
            values.swap(sorted);
        }
    );
    clusters.pointsAreSorted();
    particles.bricks.clear();
    for (std::ptrdiff_t b = 0; b < clusters.bricks(); ++b)
    {
        particles.bricks.push_back(clusters.firstPlace(clusters.firstCluster(b)));
    }
    particles.bricks.push_back(n);
    return clusters;
}

} // namespace slosh
