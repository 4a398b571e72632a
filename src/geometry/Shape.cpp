// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/Shape.hpp"

#include "dictionary/Dictionary.hpp"
#include "geometry/Box.hpp"
#include "geometry/Sphere.hpp"

#include <algorithm>
#include <sstream>

namespace slosh
{

BoundingBox readBox(const Dictionary& dict)
{
    const Vec low = dict.vector("min", unit::metre), high = dict.vector("max", unit::metre);
    for (int d = 0; d < 3; ++d)
    {
        if (!(high[d] > low[d]))
        {
            std::ostringstream message;
            message << "is not above 'min' (" << low[0] << " " << low[1] << " " << low[2] << ") in direction "
                    << "xyz"[d] << ":";
            throw dict.errorAt("max", message.str());
        }
    }
    return BoundingBox(low, high);
}

bool overlap(const BoundingBox& a, const BoundingBox& b)
{
    const BoundingBox common = a.intersection(b);
    return !common.isEmpty() && common.sizes().minCoeff() > 1e-9 * a.sizes().maxCoeff();
}

std::shared_ptr<const Shape> readShape(const Dictionary& dict, const std::string& name, const BoundingBox& tank,
                                       const std::vector<int>& directions, const std::vector<std::string>& types)
{
    const std::string type = dict.choice("type", types, "body type");
    std::shared_ptr<const Shape> shape;
    BoundingBox bounds = tank; // through the empty direction
    if (type == "searchableSphere")
    {
        const Vec centre = dict.vector("centre", unit::metre);
        const double radius = dict.scalar("radius", unit::metre, positive);
        for (const int d : directions)
        {
            bounds.min()[d] = centre[d] - radius;
            bounds.max()[d] = centre[d] + radius;
        }
        shape = std::make_shared<Sphere>(name, centre, radius, bounds, directions);
    }
    else
    {
        const BoundingBox box = readBox(dict);
        for (const int d : directions)
        {
            bounds.min()[d] = box.min()[d];
            bounds.max()[d] = box.max()[d];
        }
        shape = std::make_shared<Box>(name, bounds, directions);
    }
    dict.refuseUnknown();
    return shape;
}

} // namespace slosh
