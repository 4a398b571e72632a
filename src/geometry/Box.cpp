#include "geometry/Box.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace slosh
{

double distanceToBox(const BoundingBox& box, const std::vector<int>& directions, const Vec& X)
{
    double outside2 = 0, inside = -std::numeric_limits<double>::infinity();
    for (const int d : directions)
    {
        const double beyond = std::max(box.min()[d] - X[d], X[d] - box.max()[d]);
        inside = std::max(inside, beyond);
        outside2 += beyond > 0 ? beyond * beyond : 0;
    }
    return outside2 > 0 ? std::sqrt(outside2) : inside;
}

Box::Box(std::string name, const BoundingBox& bounds, std::vector<int> directions)
    : name_(std::move(name)), bounds_(bounds), directions_(std::move(directions))
{
}

double Box::signedDistance(const Vec& X) const
{
    return distanceToBox(bounds_, directions_, X);
}

double Box::volumeInside(const BoundingBox& box) const
{
    const BoundingBox common = bounds_.intersection(box);
    return common.isEmpty() ? 0 : common.volume();
}

} // namespace slosh
