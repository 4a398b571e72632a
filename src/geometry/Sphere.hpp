// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/Shape.hpp"

namespace slosh
{

/// searchableSphere: a sphere; in 2D a disc that extends through the empty direction.
class Sphere final : public Shape
{
public:
    Sphere(std::string name, const Vec& centre, double radius, const BoundingBox& bounds, std::vector<int> directions);

    NearestSurface nearestSurface(const Vec& X) const override;
    BoundingBox bounds() const override { return bounds_; }
    /// 4/3 pi R^3, or pi R^2 times the slice's thickness: only where it lies wholly inside or outside.
    double volumeInside(const BoundingBox& box) const override;
    std::string name() const override { return name_; }

private:
    std::string name_;
    Vec centre_;
    double radius_;
    BoundingBox bounds_;
    std::vector<int> directions_;
};

} // namespace slosh
