// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "dictionary/Key.hpp"
#include "geometry/Shape.hpp"

namespace slosh
{

struct ShapeSetting;

/// An axis-aligned box between two corners.
class Box final : public Shape
{
public:
    /// `directions`: those that count; in 2D the box extends through the empty one.
    Box(std::string name, const BoundingBox& bounds, std::vector<int> directions);

    NearestSurface nearestSurface(const Vec& X) const override;
    BoundingBox bounds() const override { return bounds_; }
    bool fillsBounds() const override { return true; }
    double volumeInside(const BoundingBox& box) const override;
    std::optional<BoundingBox> rectangleAt(double /*z*/) const override { return bounds_; }

private:
    BoundingBox bounds_;
};

/// As walls and as body. Throws CaseError where max is not above min.
std::shared_ptr<const Shape> readBox(const ShapeSetting& setting);
Keys boxKeys();           ///< its entries as walls
Keys searchableBoxKeys(); ///< as a body

} // namespace slosh
