// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/Box.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace slosh
{

NearestSurface nearestOfBox(const BoundingBox& box, const std::vector<int>& directions, const Vec& X)
{
    Vec outside = Vec::Zero();
    NearestSurface inside{-std::numeric_limits<double>::infinity(), Vec::Zero()};
    for (const int d : directions)
    {
        const double below = box.min()[d] - X[d], above = X[d] - box.max()[d];
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

Box::Box(std::string name, const BoundingBox& bounds, std::vector<int> directions)
    : name_(std::move(name)), bounds_(bounds), directions_(std::move(directions))
{
}

NearestSurface Box::nearestSurface(const Vec& X) const
{
    return nearestOfBox(bounds_, directions_, X);
}

double Box::volumeInside(const BoundingBox& box) const
{
    const BoundingBox common = bounds_.intersection(box);
    return common.isEmpty() ? 0 : common.volume();
}

} // namespace slosh
