// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "motion/SolverFrame.hpp"
#include "physics/BodyForce.hpp"

namespace slosh
{

/// The body force the liquid feels in a frame. In the tank's, with everything turned into it (R^T):
///     b(X, v) = g - c'' - omega' x X - omega x (omega x X) - 2 omega x v
/// (linear, Euler, centrifugal, Coriolis), and the walls' b_w is the same at v = 0; in the inertial one b = g, and b_w
/// = g - a_w, a_w = c'' + omega' x (x - c) + omega x (omega x (x - c)). g in the inertial frame.
BodyForce bodyForceIn(const SolverFrame& frame, const Vec& g);

} // namespace slosh
