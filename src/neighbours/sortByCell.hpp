// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "particles/Particles.hpp"

namespace slosh
{

/// Brings the liquid particles into the order of the cells they are in, within a cell of their ids, and notes their
/// bricks (Particles::bricks): columns of 12 x 12 cells of one global grid, each swept from bottom to top
/// (docs/performance.md). Neighbours stand near each other in memory, and the order is a function of positions and ids
/// alone. Walls keep their order.
void sortByCell(Particles& particles, double cellSize);

} // namespace slosh
