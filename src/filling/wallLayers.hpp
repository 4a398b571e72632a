// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/Polygon.hpp"

#include <vector>

namespace slosh
{

/// Wall particles around liquid in a polygon: `layers` rows that follow its sides at dx/2, 3 dx/2 ... behind them.
///
/// Each row is the polygon moved outward with mitred corners. Two neighbouring rows enclose dx times their mean length
/// whatever the corner is, so points dx apart along a row stand for dx^2 each: nothing is counted twice at a corner
/// that is reflex, nothing is missing at one that is not, be it acute. Between two corners that turn by more than 30
/// degrees the points are evenly spaced (the nearest to dx that fits), a point at each such corner; gentler ones are
/// taken as a curve. Around a rectangle of whole spacings that is the lattice. Left out: points farther than `layers`
/// spacings from the liquid (the far end of an acute mitre), points of a row that another side is nearer to, and points
/// within dx/2 of another (rows that meet in a thin wall).
std::vector<Vec2> wallLayers(const Polygon& liquid, double dx, int layers);

} // namespace slosh
