// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/Sphere.hpp"

#include "dictionary/Dictionary.hpp"
#include "geometry/areaOfDisc.hpp"
#include "geometry/shapeTypes.hpp"

#include <algorithm>
#include <numbers>

namespace slosh
{

namespace
{

namespace searchableSphere
{

constexpr Key centre{
    .name = "centre", .example = "(0 0.1 0.4)", .unit = unit::metre, .sentence = "the empty direction is ignored"};
constexpr Key radius{.name = "radius", .example = "0.05", .unit = unit::metre, .range = positive};

} // namespace searchableSphere

} // namespace

Keys searchableSphereKeys()
{
    return {searchableSphere::centre, searchableSphere::radius};
}

Sphere::Sphere(
    std::string name, const Vec& centre, double radius, const BoundingBox& bounds, std::vector<int> directions
)
    : Shape(std::move(name), std::move(directions)), centre_(centre), radius_(radius), bounds_(bounds)
{
}

NearestSurface Sphere::nearestSurface(const Vec& X) const
{
    Vec fromCentre = Vec::Zero();
    for (const int d : directions())
    {
        fromCentre[d] = X[d] - centre_[d];
    }
    const double r = fromCentre.norm();
    return {r - radius_, r > 0 ? Vec(fromCentre / r) : Vec(Vec::Unit(directions().front()))};
}

double Sphere::volumeInside(const BoundingBox& box) const
{
    if (!overlap(bounds_, box))
    {
        return 0;
    }
    const double pi = std::numbers::pi, R = radius_;
    const double slack = 1e-9 * R;
    const BoundingBox part = bounds_.intersection(box);
    std::vector<int> cut;
    double thickness = 1;
    for (int d = 0; d < 3; ++d)
    {
        const bool counts = std::find(directions().begin(), directions().end(), d) != directions().end();
        if (counts && (bounds_.min()[d] < box.min()[d] - slack || bounds_.max()[d] > box.max()[d] + slack))
        {
            cut.push_back(d);
        }
        thickness *= counts ? 1 : part.sizes()[d];
    }
    const bool isDisc = directions().size() == 2;
    if (cut.empty())
    {
        return isDisc ? pi * R * R * thickness : 4.0 / 3.0 * pi * R * R * R;
    }
    const Vec low = part.min() - centre_, high = part.max() - centre_;
    if (isDisc)
    {
        const int a = directions()[0], b = directions()[1];
        return thickness * areaOfDisc(R, {low[a], low[b]}, {high[a], high[b]});
    }
    if (cut.size() > 1)
    {
        return Shape::volumeInside(box);
    }
    const auto upTo = [&](double s) { return pi * (R * R * s - s * s * s / 3); };
    return upTo(high[cut.front()]) - upTo(low[cut.front()]);
}

std::shared_ptr<const Shape> readSphere(const ShapeSetting& setting)
{
    const Vec centre = setting.dict.vector(searchableSphere::centre);
    const double radius = setting.dict.scalar(searchableSphere::radius);
    BoundingBox bounds = setting.tank.value_or(BoundingBox(centre, centre));
    for (const int d : setting.directions)
    {
        bounds.min()[d] = centre[d] - radius;
        bounds.max()[d] = centre[d] + radius;
    }
    return std::make_shared<Sphere>(setting.name, centre, radius, bounds, setting.directions);
}

} // namespace slosh
