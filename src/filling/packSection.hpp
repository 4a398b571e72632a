// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Vec.hpp"

#include <vector>

namespace slosh
{

class Polygon;

/// Moves the points of a lattice in a polygon that are near its sides until they lie evenly between them and the
/// wall's: where a side cuts the lattice, points stand too near to it or too far. Each point, of volume V = dx^2,
/// gives way to the others,
///     x_a <- x_a - c h^2 sum_b V_b grad W_ab,
/// W the Gaussian with h = 1.23 dx up to 3h, until none moves by more than dx/5000, in at most 2000 rounds. Those six
/// spacings from the sides stay where they are, and the two rows on each side of the still surface, at `level` in the
/// section's second direction, move along it only, so that it stays flat. Between lattice and sides that fit nothing
/// moves.
void packSection(
    const Polygon& section, double dx, double level, const std::vector<Vec2>& wall, std::vector<Vec2>& inside
);

} // namespace slosh
