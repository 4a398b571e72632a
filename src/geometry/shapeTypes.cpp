// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/shapeTypes.hpp"

#include "dictionary/Dictionary.hpp"
#include "geometry/Box.hpp"
#include "geometry/Disc.hpp"
#include "geometry/Prism.hpp"
#include "geometry/Sphere.hpp"

namespace slosh
{

std::pair<double, double> readExtent(const Dictionary& dict)
{
    const std::vector<double> extent = dict.scalars("extent", unit::metre);
    if (extent.size() != 2 || !(extent[1] > extent[0]))
    {
        throw dict.errorAt("extent", "must be two numbers that rise, (from to), in m; it is not:");
    }
    return {extent[0], extent[1]};
}

const std::vector<ShapeType>& wallTypes()
{
    static const std::vector<ShapeType> types = {
        {"box", "a box between two corners, along the axes", readBox},
        {"disc", "a disc in the plane of a 2D scene", readDisc},
        {"prism", "a polygon drawn out along the axis across it", readPrism},
    };
    return types;
}

const std::vector<ShapeType>& bodyTypes()
{
    static const std::vector<ShapeType> types = {
        {"searchableBox", "a box between two corners, along the axes", readBox},
        {"searchableSphere", "a sphere, in 2D a disc", readSphere},
    };
    return types;
}

const ShapeType& chosenWallType(const Dictionary& dict)
{
    return choiceNamed(wallTypes(), dict.choiceOr("type", "box", namesOf(wallTypes()), "tank type"));
}

std::shared_ptr<const Shape> readBody(const ShapeSetting& setting)
{
    auto shape = choose(setting.dict, "type", bodyTypes(), "body type").read(setting);
    setting.dict.refuseUnknown();
    return shape;
}

} // namespace slosh
