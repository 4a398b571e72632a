// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/shapeTypes.hpp"

#include "dictionary/Dictionary.hpp"
#include "geometry/Box.hpp"
#include "geometry/Disc.hpp"
#include "geometry/Prism.hpp"
#include "geometry/Sphere.hpp"

namespace slosh
{

namespace
{

constexpr Key bodyType{.name = "type", .example = "searchableBox", .options = [] { return optionsOf(bodyTypes()); }};

} // namespace

Keys bodyKeys()
{
    return {bodyType};
}

Key extentKey()
{
    return {
        .name = "extent",
        .example = "(-0.5 0.5)",
        .unit = unit::metre,
        .sentence = "(from to) along the axis normal to the section; the thickness in 2D"};
}

std::pair<double, double> readExtent(const Dictionary& dict)
{
    const std::vector<double> extent = dict.scalars(extentKey());
    if (extent.size() != 2 || !(extent[1] > extent[0]))
    {
        throw dict.errorAt(extentKey(), "is not a pair of increasing numbers; expected (from to) [m]");
    }
    return {extent[0], extent[1]};
}

const std::vector<ShapeType>& wallTypes()
{
    static const std::vector<ShapeType> types = {
        {"box", "a box between two corners, aligned with the axes", readBox, boxKeys},
        {"disc", "a disc in the plane of a 2D scene", readDisc, discKeys},
        {"prism", "a polygon extruded along the axis normal to it", readPrism, prismKeys},
    };
    return types;
}

const std::vector<ShapeType>& bodyTypes()
{
    static const std::vector<ShapeType> types = {
        {"searchableBox", "a box between two corners, aligned with the axes", readBox, searchableBoxKeys},
        {"searchableSphere", "a sphere, in 2D a disc", readSphere, searchableSphereKeys},
    };
    return types;
}

std::shared_ptr<const Shape> readBody(const ShapeSetting& setting)
{
    auto shape = choose(setting.dict, bodyType, bodyTypes(), "body type").read(setting);
    setting.dict.refuseIdle(bodyKeys());
    return shape;
}

} // namespace slosh
