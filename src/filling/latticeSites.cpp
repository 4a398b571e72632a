// SPDX-License-Identifier: GPL-3.0-or-later
#include "filling/latticeSites.hpp"

namespace slosh
{

ParticleSites latticeSites(const Tank& tank, const Lattice& lattice)
{
    const auto& [axes, heights, wallLayers] = lattice;
    double deepest = 0; // behind walls that are no box
    for (const int d : tank.directions())
    {
        deepest = std::max(deepest, wallLayers * axes[d].spacing);
    }
    ParticleSites sites;
    for (int k = axes[2].first; k < axes[2].last; ++k)
    {
        for (int j = axes[1].first; j < axes[1].last; ++j)
        {
            for (int i = axes[0].first; i < axes[0].last; ++i)
            {
                const Vec X(axes[0].centre(i), axes[1].centre(j), heights[k - axes[2].first]);
                const double behind = tank.isBox() ? 0 : tank.walls().signedDistance(X);
                if (behind > deepest)
                {
                    continue;
                }
                const bool inWallLayers = behind > 0 || k < 0 || k >= axes[2].last - wallLayers ||
                                          (tank.emptyDirection() != 0 && (i < 0 || i >= axes[0].last - wallLayers)) ||
                                          (tank.emptyDirection() != 1 && (j < 0 || j >= axes[1].last - wallLayers));
                if (inWallLayers || isInBody(tank, X))
                {
                    sites.wall.push_back(X);
                }
                else if (tank.fill().contains(X))
                {
                    sites.liquid.push_back(X);
                }
            }
        }
    }
    return sites;
}

} // namespace slosh
