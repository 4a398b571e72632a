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
/// W of Wendland (C2, h = 1.3 dx, 2D), until none moves by more than dx/1000, in at most 1000 rounds. Those six
/// spacings from the sides stay where they are. Between lattice and sides that fit nothing moves.
void packSection(const Polygon& section, double dx, const std::vector<Vec2>& wall, std::vector<Vec2>& inside);

} // namespace slosh
