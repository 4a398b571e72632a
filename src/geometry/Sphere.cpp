// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/Sphere.hpp"

#include <algorithm>
#include <numbers>
#include <stdexcept>

namespace slosh
{

Sphere::Sphere(std::string name, const Vec& centre, double radius, const BoundingBox& bounds,
               std::vector<int> directions)
    : name_(std::move(name)), centre_(centre), radius_(radius), bounds_(bounds), directions_(std::move(directions))
{
}

NearestSurface Sphere::nearestSurface(const Vec& X) const
{
    Vec fromCentre = Vec::Zero();
    for (const int d : directions_)
    {
        fromCentre[d] = X[d] - centre_[d];
    }
    const double r = fromCentre.norm();
    return {r - radius_, r > 0 ? Vec(fromCentre / r) : Vec(Vec::Unit(directions_.front()))};
}

double Sphere::volumeInside(const BoundingBox& box) const
{
    if (!overlap(bounds_, box))
    {
        return 0;
    }
    double thickness = 1;
    for (int d = 0; d < 3; ++d)
    {
        const bool counts = std::find(directions_.begin(), directions_.end(), d) != directions_.end();
        const double slack = 1e-9 * radius_;
        if (counts && (bounds_.min()[d] < box.min()[d] - slack || bounds_.max()[d] > box.max()[d] + slack))
        {
            throw std::logic_error("a sphere that is cut");
        }
        thickness *= counts ? 1 : bounds_.sizes()[d];
    }
    const double pi = std::numbers::pi;
    return directions_.size() == 2 ? pi * radius_ * radius_ * thickness : 4.0 / 3.0 * pi * radius_ * radius_ * radius_;
}

} // namespace slosh
