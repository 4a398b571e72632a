// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Vec.hpp"

#include <memory>
#include <string>
#include <vector>

namespace slosh
{

class Dictionary;

/// The nearest point of a surface, seen from X.
struct NearestSurface
{
    double distance = 0;      ///< to it, [m]: positive outside the shape, negative inside
    Vec normal = Vec::Zero(); ///< gradient of the distance: out of the shape
};

/// A region of the tank, a solid body or the liquid at the start; in tank coordinates.
class Shape
{
public:
    virtual ~Shape() = default;
    virtual NearestSurface nearestSurface(const Vec& X) const = 0;
    double signedDistance(const Vec& X) const { return nearestSurface(X).distance; }
    virtual BoundingBox bounds() const = 0;
    /// Volume of the part inside `box`, [m^3]. Throws std::logic_error where it is not known in closed form (a sphere
    /// that sticks out).
    virtual double volumeInside(const BoundingBox& box) const = 0;
    virtual std::string name() const = 0;
};

using Shapes = std::vector<std::shared_ptr<const Shape>>;

/// Reads { type searchableBox; min (..); max (..); } or { type searchableSphere; centre (..); radius ..; }, OpenFOAM's
/// names. `tank`: the box of the tank; in 2D a shape extends through the empty direction (`directions` are the others),
/// a sphere is a disc there. `types`: those allowed. Throws CaseError.
std::shared_ptr<const Shape> readShape(const Dictionary& dict, const std::string& name, const BoundingBox& tank,
                                       const std::vector<int>& directions, const std::vector<std::string>& types);

/// A box from its entries min and max, [m]. Throws CaseError where max is not above min.
BoundingBox readBox(const Dictionary& dict);

/// Whether two boxes share more than a face.
bool overlap(const BoundingBox& a, const BoundingBox& b);

} // namespace slosh
