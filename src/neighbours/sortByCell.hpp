// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "particles/Particles.hpp"

namespace slosh
{

/// Brings the liquid particles into the order of the cells they are in, within a cell of their ids: neighbours stand
/// near each other in memory, and the order is a function of the positions alone. Wide tanks in 3D are swept in
/// columns, each from bottom to top (docs/performance.md). Walls keep their order.
void sortByCell(Particles& particles, double cellSize);

} // namespace slosh
