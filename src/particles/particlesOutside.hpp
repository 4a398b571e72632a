// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/Tank.hpp"
#include "motion/SolverFrame.hpp"
#include "particles/Particles.hpp"

#include <vector>

namespace slosh
{

/// Indices of the liquid particles that have leaked: whose centre is more than dx/2 deep in a wall or a body, where the
/// first layer of wall particles stands, or beyond. Empty in a sound run.
std::vector<std::ptrdiff_t> particlesOutside(const Tank& tank, const Particles& particles, const SolverFrame& frame);

} // namespace slosh
