// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filling/ParticleSites.hpp"

namespace slosh
{

/// Particles at the centres of the lattice's cells, for walls of any shape: liquid where the centre lies in the liquid,
/// wall where it lies in a body or up to `wallLayers` cells behind the walls. Of a box the layers are whole; walls that
/// cut the lattice become steps.
ParticleSites latticeSites(const Tank& tank, const Lattice& lattice);

} // namespace slosh
