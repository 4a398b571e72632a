// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "particles/Particles.hpp"
#include "scene/Scene.hpp"

namespace slosh
{

/// Vorticity omega = curl v of the liquid, [1/s], one value a particle (walls: zero), in the frame of its velocities:
///
///     A_a = G M^-1,   G = sum_b V_b (v_b - v_a) (x) grad_a W_ab,   M = sum_b V_b (r_b - r_a) (x) grad_a W_ab,
///     omega = (A_zy - A_yz, A_xz - A_zx, A_yx - A_xy),             V = m/rho,
///
/// over the liquid alone: walls do not shear it here. M makes it exact in a velocity that is linear in space, at the
/// surface and at walls as well; where it is the unit matrix, omega = sum_b V_b (v_a - v_b) x grad_a W_ab. Zero where a
/// particle has too few neighbours to tell, det M < 0.01. Source: Bonet &
/// Lok, Comput. Methods Appl. Mech. Eng. 180 (1999) 97, for the correction.
Field vorticity(const Particles& particles, const Scene& scene);

} // namespace slosh
