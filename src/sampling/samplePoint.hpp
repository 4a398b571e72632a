// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "sampling/Snapshot.hpp"

namespace slosh
{

/// The share of a point's surroundings that is liquid, walls counting for nothing:
///   F = sum_f V_f W / (1 - sum_w V_w W),  V = m/rho:
/// 1 within the liquid up to the wall, 1/2 on its surface, 0 far from it.
double volumeFraction(const Snapshot& snapshot, const Vec& X);

/// What the liquid within the kernel's support of a point has in the mean.
struct LiquidMean
{
    Vec velocity = Vec::Zero(); ///< sum_f (v_f + omega x (r - r_f)) W / sum_f W, in the snapshot's frame, [m/s]
    double pressure = 0;        ///< sum_f (p_f + rho_f b . (r - r_f)) W / sum_f W, [Pa]
};

/// At X in tank coordinates; all zero where no liquid is in reach. Carried to X are the pressure by the local body
/// force b (as a wall particle feels it, Cao et al. 2014, Eq. 13) and the velocity by how the tank turns against the
/// frame, so that both frames agree: velocities relative to the tank are plain means, on a surface that of the liquid
/// some half a smoothing length below.
LiquidMean liquidMean(const Snapshot& snapshot, const Vec& X);

/// Pressure at a point X fixed to the tank (tank coordinates), [Pa]: liquidMean()'s from the liquid on its one side; 0
/// where it is dry: where F < 1/2, above the surface. At a wall, nearer to it than half a spacing, what the wall
/// feels: max(p, 0) unless walls pull (docs/decisions/0012-probes-on-walls.md).
double pressureAt(const Snapshot& snapshot, const Vec& X);

/// Height of the liquid's topmost surface on the line through X along the tank's vertical: its z in tank coordinates,
/// [m]; the tank's bottom where the line meets no liquid, its roof where liquid reaches it. From z_s, the topmost point
/// with F = 1/2, by the volume about it,
///   z = z_s - R + int F dz from z_s - R to z_s + R,   R the kernel's support, both ends within the tank,
/// which does not change with where the outermost particles happen to stand (docs/decisions/0019-wave-gauge.md). Where
/// the liquid below z_s is thinner than R (drops, overturning crests) it is z_s itself.
double surfaceLevel(const Snapshot& snapshot, const Vec& X);

} // namespace slosh
