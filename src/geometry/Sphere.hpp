// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "dictionary/Key.hpp"
#include "geometry/Shape.hpp"

namespace slosh
{

struct ShapeSetting;

/// A sphere; in 2D a disc that extends through the empty direction.
class Sphere final : public Shape
{
public:
    /// `bounds`: the box around it, in the empty direction as far as it extends.
    Sphere(std::string name, const Vec& centre, double radius, const BoundingBox& bounds, std::vector<int> directions);

    NearestSurface nearestSurface(const Vec& X) const override;
    BoundingBox bounds() const override { return bounds_; }
    /// 4/3 pi R^3, or pi R^2 times the slice's thickness; cut, it is exact in 2D and where cuts are along one direction
    /// in 3D, integral of pi (R^2 - s^2) ds.
    double volumeInside(const BoundingBox& box) const override;

private:
    Vec centre_;
    double radius_;
    BoundingBox bounds_;
};

/// Throws CaseError.
std::shared_ptr<const Shape> readSphere(const ShapeSetting& setting);
Keys searchableSphereKeys();

} // namespace slosh
