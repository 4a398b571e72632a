// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "dictionary/Key.hpp"
#include "geometry/Shape.hpp"

namespace slosh
{

struct ShapeSetting;

/// A disc in the plane of a 2D scene: a circular tank lying across it, or a drum.
class Disc final : public Shape
{
public:
    /// `plane`: the scene's directions; `low` to `high` in the empty one.
    Disc(const Vec& centre, double radius, const std::vector<int>& plane, double low, double high);

    /// distance = |X - centre| - R in the plane.
    NearestSurface nearestSurface(const Vec& X) const override;
    BoundingBox bounds() const override { return bounds_; }
    /// Exact, see areaOfDisc().
    double volumeInside(const BoundingBox& box) const override;
    std::vector<std::pair<double, double>> chords(int along, const Vec& X) const override;
    Outline outline() const override; ///< 128 sides
    std::optional<DrawnSection> section(double dx) const override;

private:
    Vec2 fromCentre(const Vec& X) const;
    /// A regular polygon of the disc's area.
    DrawnSection polygon(int sides) const;

    Vec centre_;
    double radius_;
    BoundingBox bounds_;
};

/// Throws CaseError: a scene in 3D, a bad entry.
std::shared_ptr<const Shape> readDisc(const ShapeSetting& setting);
Keys discKeys();

} // namespace slosh
