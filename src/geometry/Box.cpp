// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/Box.hpp"

#include "dictionary/Dictionary.hpp"
#include "geometry/shapeTypes.hpp"

#include <algorithm>
#include <limits>
#include <sstream>

namespace slosh
{

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
    const Vec low = setting.dict.vector("min", unit::metre), high = setting.dict.vector("max", unit::metre);
    for (int d = 0; d < 3; ++d)
    {
        if (!(high[d] > low[d]))
        {
            std::ostringstream message;
            message << "is not above 'min' (" << low[0] << " " << low[1] << " " << low[2] << ") in direction "
                    << "xyz"[d] << ":";
            throw setting.dict.errorAt("max", message.str());
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
