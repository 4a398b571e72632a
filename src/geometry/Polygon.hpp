// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Vec.hpp"

#include <string>
#include <utility>
#include <vector>

namespace slosh
{

/// The nearest point of a polygon's sides, seen from a point of its plane.
struct NearestSide
{
    double distance = 0;        ///< to it, [m]: positive outside, negative inside
    Vec2 normal = Vec2::Zero(); ///< gradient of the distance: out of the polygon
};

/// A simple polygon, convex or not.
class Polygon
{
public:
    /// `corners`: in order round it, either way, without a fault().
    explicit Polygon(std::vector<Vec2> corners);

    /// What makes `corners` no simple polygon, as the rest of a sentence that begins with them ("has two corners ..."):
    /// fewer than 3, a repeated one, no area, one on the straight line between its neighbours, sides that meet. Empty
    /// where nothing does.
    static std::string fault(const std::vector<Vec2>& corners);

    const std::vector<Vec2>& corners() const { return corners_; } ///< anticlockwise, [m]
    const Vec2& corner(std::ptrdiff_t i) const;                   ///< any i: round and round
    Vec2 outward(std::ptrdiff_t side) const;                      ///< normal of the side from corner(side) to the next
    const Vec2& low() const { return low_; }                      ///< of the box around it, [m]
    const Vec2& high() const { return high_; }
    bool isRectangle() const; ///< along the axes

    double area() const { return areaInside(low_, high_); }     ///< [m^2]
    double areaInside(const Vec2& low, const Vec2& high) const; ///< of the part in a rectangle, exact, [m^2]
    /// Where the line along the axis `along` (0 or 1) at `at` on the other axis is inside: [from, to] in order, [m].
    std::vector<std::pair<double, double>> chords(int along, double at) const;

    bool contains(const Vec2& x) const;
    NearestSide nearest(const Vec2& x) const;

private:
    std::vector<Vec2> corners_;
    Vec2 low_, high_;
};

} // namespace slosh
