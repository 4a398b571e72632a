// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filling/ParticleSites.hpp"

namespace slosh
{

/// Particles of a tank whose walls are a section drawn out. It is filled with the cells of the lattice whose centres
/// are deepest inside, as many as its area has room for, and these are packed between its walls (wallLayers(),
/// packSection()); section by section this is repeated along the third axis, whose ends are closed by `wallLayers`
/// sections of wall. The part of the section below the still surface has its own count of cells, so that the liquid's
/// density is right.
ParticleSites sectionSites(const Tank& tank, const DrawnSection& section, const Lattice& lattice);

} // namespace slosh
