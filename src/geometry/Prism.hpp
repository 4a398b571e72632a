// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/Polygon.hpp"
#include "geometry/Shape.hpp"

#include <array>

namespace slosh
{

/// A polygon in one of the planes xz, yz and xy, drawn out along the other axis.
class Prism final : public Shape
{
public:
    /// `axes`: those of the polygon's plane; `low` to `high` along the other one, which does not count in 2D
    /// (`isSlice`).
    Prism(Polygon section, std::array<int, 2> axes, double low, double high, bool isSlice);

    /// Reads
    ///     section  yz;                     // xz | yz | xy
    ///     polygon  ((-20 -10) (20 -10) (20 5) (0 20) (-20 5)); // corners in order, in the section's axes, [m]
    ///     extent   (-20 20);               // along the other axis, [m]
    /// `plane`: that of a 2D scene, or none. Throws CaseError: a section that is not the plane, an extent that does not
    /// rise, a polygon with a fault.
    static Prism read(const Dictionary& dict, const std::string& plane);

    const Polygon& section() const { return section_; }
    const std::array<int, 2>& axes() const { return axes_; }
    int along() const { return 3 - axes_[0] - axes_[1]; }
    Vec2 inSection(const Vec& X) const { return {X[axes_[0]], X[axes_[1]]}; }
    Vec point(const Vec2& x, double along) const;

    /// Whether the section holds X; between the ends or not.
    bool sectionContains(const Vec& X) const { return section_.contains(inSection(X)); }
    NearestSurface nearestSurface(const Vec& X) const override;
    BoundingBox bounds() const override
    {
        return BoundingBox(point(section_.low(), low_), point(section_.high(), high_));
    }
    double volumeInside(const BoundingBox& box) const override;
    std::string name() const override { return "prism"; }

private:
    Polygon section_;
    std::array<int, 2> axes_;
    double low_, high_;
    bool isSlice_;
};

} // namespace slosh
