// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Vec.hpp"
#include "geometry/DrawnSection.hpp"
#include "geometry/Outline.hpp"

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace slosh
{

/// The nearest point of a surface, seen from X.
struct NearestSurface
{
    double distance = 0;      ///< to it, [m]: positive outside the shape, negative inside
    Vec normal = Vec::Zero(); ///< gradient of the distance: out of the shape
};

/// The walls of a tank, a solid body in it or a region of liquid at the start; in tank coordinates. In 2D a shape
/// extends through the empty direction. A shape must say where its surface is and the box around it; all else follows
/// from these by sampling; a shape with exact formulas overrides it. One that users can choose has its line in
/// shapeTypes.cpp.
class Shape
{
public:
    virtual ~Shape() = default;

    const std::string& name() const { return name_; }                  ///< what messages call it
    const std::vector<int>& directions() const { return directions_; } ///< those that count: {1, 2} in the yz plane

    virtual NearestSurface nearestSurface(const Vec& X) const = 0;
    double signedDistance(const Vec& X) const { return nearestSurface(X).distance; } ///< [m]
    /// The smallest box around it, [m]; its extent in the empty direction is the slice's thickness.
    virtual BoundingBox bounds() const = 0;

    /// Whether X is inside; tanks ask it of every particle.
    virtual bool contains(const Vec& X) const { return signedDistance(X) < 0; }
    /// Whether it is all of bounds().
    virtual bool fillsBounds() const { return false; }
    /// Volume of the part inside `box`, [m^3]; by volumeByQuadrature(), with its error.
    virtual double volumeInside(const BoundingBox& box) const;
    /// Where the line through X along the direction `along` is inside: [from, to] in order, [m]. Gaps and pieces of
    /// less than a thousandth of bounds() may be missed.
    virtual std::vector<std::pair<double, double>> chords(int along, const Vec& X) const;
    /// bounds() with the horizontal extent of the rectangle that a plane at z cuts out of it. None: it cuts out
    /// anything else, or, in 3D, what it cuts out is not known.
    virtual std::optional<BoundingBox> rectangleAt(double z) const;
    /// Its edges: in 2D in the middle of the empty direction. Those of bounds().
    virtual Outline outline() const;
    /// Of a shape that is a section drawn out along an axis: that section, a curve as a polygon of the same area that
    /// follows it to `dx`/100. It is filled section by section, any other shape on a lattice.
    virtual std::optional<DrawnSection> section(double dx) const;
    /// For reports, "a prism of 8 sides"; nothing of one that fills its bounds.
    virtual std::string description() const { return fillsBounds() ? "" : "a " + name_; }

protected:
    Shape(std::string name, std::vector<int> directions) : name_(std::move(name)), directions_(std::move(directions)) {}

private:
    std::string name_;
    std::vector<int> directions_;
};

using Shapes = std::vector<std::shared_ptr<const Shape>>;

/// Whether two boxes share more than a face.
bool overlap(const BoundingBox& a, const BoundingBox& b);

} // namespace slosh
