// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/Tank.hpp"

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

/// Where particles stand, [m].
struct ParticleSites
{
    std::vector<Vec> liquid, wall;
};

/// Whether X is in a body or on its face: a wall particle stands there.
bool isInBody(const Tank& tank, const Vec& X);

/// Particles of a prism. Its section is filled with the cells of the lattice whose centres are deepest inside, as many
/// as its area has room for, and these are packed between its walls (wallLayers(), packSection()); section by section
/// this is repeated along the prism, whose ends are closed by `wallLayers` sections of wall. The part of the section
/// below the still surface has its own count of cells, so that the liquid's density is right. `heights`: of the
/// lattice's layers, from axes[2].first.
ParticleSites prismSites(const Tank& tank, const std::array<LatticeAxis, 3>& axes, int wallLayers,
                         const std::vector<double>& heights);

} // namespace slosh
