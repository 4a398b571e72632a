// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "dictionary/Choice.hpp"
#include "geometry/Shape.hpp"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace slosh
{

/// What a shape is read from.
struct ShapeSetting
{
    const Dictionary& dict;
    std::string name;            ///< what messages call it
    std::vector<int> directions; ///< of the scene: {1, 2} in the yz plane
    /// Around a body or a region of liquid, which extends through the empty direction of it. None: the shape is the
    /// tank's walls and says itself how far it extends.
    std::optional<BoundingBox> tank;
};

/// A shape by the name that a dictionary gives as its `type`.
using ShapeType = Choice<std::shared_ptr<const Shape> (*)(const ShapeSetting&)>;

/// How far a section is drawn out along the third axis, [m]. Throws CaseError where it does not rise.
std::pair<double, double> readExtent(const Dictionary& dict);
Key extentKey();

/// Those that walls can have, and those of bodies and regions of liquid, which have OpenFOAM's names.
const std::vector<ShapeType>& wallTypes();
const std::vector<ShapeType>& bodyTypes();

/// Reads a body or region of liquid. Throws CaseError: another name, a bad entry, one too many.
std::shared_ptr<const Shape> readBody(const ShapeSetting& setting);
/// Entries of a body.
Keys bodyKeys();

} // namespace slosh
