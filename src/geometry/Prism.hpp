// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "dictionary/Key.hpp"
#include "geometry/Shape.hpp"

namespace slosh
{

struct ShapeSetting;

/// A polygon in one of the planes xz, yz and xy, drawn out along the other axis.
class Prism final : public Shape
{
public:
    /// `low` to `high` along the third axis, which does not count in 2D (`isSlice`).
    Prism(DrawnSection section, double low, double high, bool isSlice);

    NearestSurface nearestSurface(const Vec& X) const override;
    BoundingBox bounds() const override;
    bool contains(const Vec& X) const override;
    double volumeInside(const BoundingBox& box) const override;
    std::vector<std::pair<double, double>> chords(int along, const Vec& X) const override;
    std::optional<BoundingBox> rectangleAt(double z) const override;
    Outline outline() const override;
    std::optional<DrawnSection> section(double /*dx*/) const override { return section_; }
    std::string description() const override;

private:
    DrawnSection section_;
    double low_, high_;
    bool isSlice_;
};

/// One whose section is a rectangle along the axes is a Box. Throws CaseError: a section that is not the plane of a 2D
/// scene, an extent that does not rise, a polygon with a fault.
std::shared_ptr<const Shape> readPrism(const ShapeSetting& setting);
Keys prismKeys();

} // namespace slosh
