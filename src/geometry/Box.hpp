// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/Shape.hpp"

namespace slosh
{

/// searchableBox: an axis-aligned box between two corners.
class Box final : public Shape
{
public:
    /// `directions`: those that count; in 2D the box extends through the empty one.
    Box(std::string name, const BoundingBox& bounds, std::vector<int> directions);

    NearestSurface nearestSurface(const Vec& X) const override;
    BoundingBox bounds() const override { return bounds_; }
    double volumeInside(const BoundingBox& box) const override;
    std::string name() const override { return name_; }

private:
    std::string name_;
    BoundingBox bounds_;
    std::vector<int> directions_;
};

/// The nearest point of the faces of a box, over the directions given.
NearestSurface nearestOfBox(const BoundingBox& box, const std::vector<int>& directions, const Vec& X);

} // namespace slosh
