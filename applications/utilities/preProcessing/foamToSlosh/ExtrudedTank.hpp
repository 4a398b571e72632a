// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "BlockMesh.hpp"

#include "base/Vec.hpp"

#include <string>
#include <vector>

namespace slosh
{

/// A tank: a polygon drawn out along an axis.
struct ExtrudedTank
{
    int axis = 1; ///< 0 x, 1 y, 2 z; the polygon lies in the plane of the other two, in this order
    std::vector<Eigen::Vector2d> polygon; ///< its corners, counter-clockwise, none of them on a straight side, [m]
    double low = 0, high = 0;             ///< the extent along the axis, [m]
    bool flat = false;                    ///< one layer of cells between empty patches: 2D

    BoundingBox bounds() const;
    double area() const; ///< of the polygon, [m^2]
    bool isBox() const;  ///< a rectangle along the axes
    /// Whether X is inside or, to 1e-9 of the size, on the surface; along the axis of a flat one anywhere.
    bool contains(const Vec& X) const;
    /// Of what is below z = level, [m^3].
    double volumeBelow(double level) const;

    /// The outer surface of the blocks: faces that no two share. Throws CaseError where that is no prism of one
    /// polygon, or the empty faces are not the two ends of it.
    static ExtrudedTank of(const BlockMesh& mesh);
};

/// The outer faces of the blocks, each with its patch.
struct OuterFace
{
    BlockMesh::Face corners; ///< different ones
    std::string patch, type;
};
std::vector<OuterFace> outerFaces(const BlockMesh& mesh);

} // namespace slosh
