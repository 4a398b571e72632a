// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/Tank.hpp"

#include <algorithm>
#include <array>
#include <vector>

namespace slosh
{

/// Cells of one direction: the liquid's and the walls', centre of cell k at origin + (k + 1/2) spacing.
struct LatticeAxis
{
    double origin = 0, spacing = 0;
    int first = 0, last = 0; ///< [first, last), wall layers included

    double centre(int k) const { return origin + (k + 0.5) * spacing; }
};

/// The lattice in and around a tank.
struct Lattice
{
    std::array<LatticeAxis, 3> axes;
    std::vector<double> heights; ///< of the layers' centres, from axes[2].first, [m]
    int wallLayers = 0;
};

/// Where particles stand, [m].
struct ParticleSites
{
    std::vector<Vec> liquid, wall;
};

/// Whether X is in a body or on its face: a wall particle stands there.
inline bool isInBody(const Tank& tank, const Vec& X)
{
    return std::any_of(
        tank.bodies().begin(), tank.bodies().end(), [&](const auto& body) { return body->signedDistance(X) <= 0; }
    );
}

} // namespace slosh
