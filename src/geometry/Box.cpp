// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/Box.hpp"

#include "dictionary/Dictionary.hpp"
#include "geometry/shapeTypes.hpp"

#include <algorithm>
#include <limits>
#include <sstream>

namespace slosh
{

namespace
{

namespace box
{

constexpr Key min{
    .name = "min",
    .example = "(-0.5 -0.46 0)",
    .unit = unit::metre,
    .sentence = "inner corner; particles lie at the mean of the empty direction"};
constexpr Key max{.name = "max", .example = "(0.5 0.46 0.62)", .unit = unit::metre, .sentence = "the opposite corner"};

} // namespace box

namespace searchableBox
{

constexpr Key min{
    .name = "min",
    .example = "(-0.5 -0.03 0)",
    .unit = unit::metre,
    .sentence = "corner; the empty direction is ignored"};
constexpr Key max{.name = "max", .example = "(0.5 0.03 0.06)", .unit = unit::metre, .sentence = "the opposite corner"};

} // namespace searchableBox

} // namespace

Keys boxKeys()
{
    return {box::min, box::max};
}

Keys searchableBoxKeys()
{
    return {searchableBox::min, searchableBox::max};
}

Box::Box(std::string name, const BoundingBox& bounds, std::vector<int> directions)
    : Shape(std::move(name), std::move(directions)), bounds_(bounds)
{
}

NearestSurface Box::nearestSurface(const Vec& X) const
{
    Vec outside = Vec::Zero();
    NearestSurface inside{-std::numeric_limits<double>::infinity(), Vec::Zero()};
    for (const int d : directions())
    {
        const double below = bounds_.min()[d] - X[d], above = X[d] - bounds_.max()[d];
        const double beyond = std::max(below, above);
        const double sign = above >= below ? 1 : -1;
        if (beyond > inside.distance)
        {
            inside.distance = beyond;
            inside.normal = sign * Vec::Unit(d);
        }
        outside[d] = beyond > 0 ? sign * beyond : 0;
    }
    const double distance = outside.norm();
    return distance > 0 ? NearestSurface{distance, outside / distance} : inside;
}

double Box::volumeInside(const BoundingBox& box) const
{
    const BoundingBox common = bounds_.intersection(box);
    return common.isEmpty() ? 0 : common.volume();
}

std::shared_ptr<const Shape> readBox(const ShapeSetting& setting)
{
    // A body's are of the same names and unit.
    const Vec low = setting.dict.vector(box::min), high = setting.dict.vector(box::max);
    for (int d = 0; d < 3; ++d)
    {
        if (!(high[d] > low[d]))
        {
            std::ostringstream message;
            message << "is not above 'min' (" << low[0] << " " << low[1] << " " << low[2] << ") in direction "
                    << "xyz"[d] << "";
            throw setting.dict.errorAt(box::max, message.str());
        }
    }
    BoundingBox bounds = setting.tank.value_or(BoundingBox(low, high));
    for (const int d : setting.directions)
    {
        bounds.min()[d] = low[d];
        bounds.max()[d] = high[d];
    }
    return std::make_shared<Box>(setting.name, bounds, setting.directions);
}

} // namespace slosh
