#include "geometry/Tank.hpp"

#include "dictionary/Dictionary.hpp"
#include "geometry/Box.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <sstream>

namespace slosh
{

Tank Tank::read(const Dictionary& dict)
{
    Tank tank;
    dict.choiceOr("type", "box", {"box"}, "tank type");
    const std::string plane = dict.choiceOr("plane", "none", {"xz", "yz", "none"}, "plane");
    tank.dim_ = plane == "none" ? 3 : 2;
    tank.emptyDirection_ = plane == "xz" ? 1 : plane == "yz" ? 0 : -1;
    for (int d = 0; d < 3; ++d)
    {
        if (d != tank.emptyDirection_)
        {
            tank.directions_.push_back(d);
        }
    }
    tank.box_ = readBox(dict);
    tank.low_ = tank.box_.min();
    tank.high_ = tank.box_.max();
    if (tank.emptyDirection_ >= 0)
    {
        tank.low_[tank.emptyDirection_] = -std::numeric_limits<double>::infinity();
        tank.high_[tank.emptyDirection_] = std::numeric_limits<double>::infinity();
    }

    const Dictionary geometry = dict.dictOr("geometry");
    for (const auto& name : geometry.keys())
    {
        const auto body = readShape(geometry.dict(name), name, tank.box_, tank.directions_, {"searchableBox"});
        if (!overlap(body->bounds(), tank.box_))
        {
            throw geometry.errorAt(name, "lies outside the tank,");
        }
        // What sticks out of the tank is in the wall already.
        const BoundingBox inside = body->bounds().intersection(tank.box_);
        for (const auto& other : tank.bodies_)
        {
            if (overlap(inside, other->bounds()))
            {
                throw geometry.errorAt(name, "overlaps '" + other->name() + "',");
            }
        }
        tank.bodies_.push_back(std::make_shared<Box>(name, inside, tank.directions_));
    }
    tank.fill_ = Fill::read(dict, tank.box_, tank.bodies_, tank.directions_);
    dict.refuseUnknown();
    return tank;
}

double Tank::thickness() const
{
    return emptyDirection_ < 0 ? 1 : box_.sizes()[emptyDirection_];
}

bool Tank::inBody(const Vec& X) const
{
    return std::any_of(bodies_.begin(), bodies_.end(), [&](const auto& body) { return body->signedDistance(X) < 0; });
}

NearestSurface Tank::nearestWall(const Vec& X) const
{
    NearestSurface nearest = nearestOfBox(box_, directions_, X);
    nearest.distance *= -1; // the liquid is inside
    nearest.normal *= -1;
    for (const auto& body : bodies_)
    {
        if (const NearestSurface surface = body->nearestSurface(X); surface.distance < nearest.distance)
        {
            nearest = surface;
        }
    }
    return nearest;
}

std::vector<double> Tank::naturalFrequencies(double gravity, int count) const
{
    const double pi = std::numbers::pi;
    const double L = box_.sizes()[directions_[0]];
    const double B = dim_ == 3 ? box_.sizes()[directions_[1]] : 0;
    std::vector<double> omega;
    for (int m = 0; m <= count; ++m)
    {
        for (int n = 0; n <= (dim_ == 3 ? count : 0); ++n)
        {
            const double kappa = pi * std::hypot(m / L, n == 0 ? 0 : n / B);
            if (kappa > 0)
            {
                omega.push_back(std::sqrt(gravity * kappa * std::tanh(kappa * fillDepth())));
            }
        }
    }
    std::sort(omega.begin(), omega.end());
    omega.resize(static_cast<std::size_t>(count));
    return omega;
}

} // namespace slosh
