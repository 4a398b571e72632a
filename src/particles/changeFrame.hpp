// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "motion/SolverFrame.hpp"
#include "particles/Particles.hpp"

namespace slosh
{

/// Positions and velocities of all particles from one frame to the other, the tank standing as from.tank() says:
///   x = c + R X,  v = v_tank(X) + R V;  X = R^T (x - c),  V = R^T (v - v_tank(X)).
void changeFrame(Particles& particles, const SolverFrame& from, Frame to);

} // namespace slosh
