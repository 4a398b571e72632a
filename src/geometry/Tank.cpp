#include "geometry/Tank.hpp"

#include "dictionary/Dictionary.hpp"
#include "geometry/Box.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>

namespace slosh
{

namespace
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

/// Volume of the part of a box below z = level; the empty direction included.
double volumeBelow(const BoundingBox& box, double level)
{
    const Vec size = box.sizes();
    return size.x() * size.y() * std::clamp(level - box.min().z(), 0.0, size.z());
}

bool overlap(const BoundingBox& a, const BoundingBox& b)
{
    const BoundingBox common = a.intersection(b);
    return !common.isEmpty() && common.sizes().minCoeff() > 1e-9 * a.sizes().maxCoeff();
}

} // namespace

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

    const Dictionary geometry = dict.dictOr("geometry");
    for (const auto& name : geometry.keys())
    {
        const Dictionary body = geometry.dict(name);
        body.choice("type", {"searchableBox"}, "type of body");
        BoundingBox bounds = readBox(body);
        if (tank.emptyDirection_ >= 0)
        {
            bounds.min()[tank.emptyDirection_] = tank.box_.min()[tank.emptyDirection_];
            bounds.max()[tank.emptyDirection_] = tank.box_.max()[tank.emptyDirection_];
        }
        body.refuseUnknown();
        // What sticks out of the tank is in the wall already.
        const BoundingBox inside = bounds.intersection(tank.box_);
        if (!overlap(bounds, tank.box_))
        {
            throw geometry.errorAt(name, "lies outside the tank,");
        }
        for (const auto& other : tank.bodies_)
        {
            if (overlap(inside, other->bounds()))
            {
                throw geometry.errorAt(name, "overlaps '" + other->name() + "',");
            }
        }
        tank.bodies_.push_back(std::make_shared<Box>(name, inside, tank.directions_));
    }

    const double bottom = tank.box_.min().z(), roof = tank.box_.max().z();
    const auto volumeUpTo = [&](double level)
    {
        double volume = volumeBelow(tank.box_, level);
        for (const auto& body : tank.bodies_)
        {
            volume -= volumeBelow(body->bounds(), level);
        }
        return volume;
    };
    std::string given;
    for (const auto* key : {"fillDepth", "fillLevel", "fillVolume"})
    {
        if (dict.has(key))
        {
            if (!given.empty())
            {
                throw dict.errorAt(key, "is set besides '" + given + "': give one of them,");
            }
            given = key;
        }
    }
    if (given.empty())
    {
        dict.scalar("fillDepth", unit::metre); // says that it is missing
    }
    if (given == "fillVolume")
    {
        const double volume = dict.scalar(given, unit::cubicMetre, positive);
        if (volume > volumeUpTo(roof) * (1 + 1e-12))
        {
            std::ostringstream message;
            message << "is " << volume << " m^3, more than the " << volumeUpTo(roof) << " m^3 the tank holds,";
            throw dict.errorAt(given, message.str());
        }
        double low = bottom, high = roof; // the volume rises with the level: bisection to the last bit
        for (double middle = (low + high) / 2; middle > low && middle < high; middle = (low + high) / 2)
        {
            (volumeUpTo(middle) < volume ? low : high) = middle;
        }
        tank.fillLevel_ = high;
    }
    else if (given == "fillDepth")
    {
        tank.fillLevel_ = bottom + dict.scalar(given, unit::metre, positive);
    }
    else
    {
        tank.fillLevel_ = dict.scalar(given, unit::metre);
        if (!(tank.fillLevel_ > bottom))
        {
            std::ostringstream message;
            message << "is " << tank.fillLevel_ << " m, not above the tank's bottom at z = " << bottom << " m,";
            throw dict.errorAt(given, message.str());
        }
    }
    if (tank.fillLevel_ > roof * (1 + 1e-12) + 1e-12 * (roof - bottom))
    {
        std::ostringstream message;
        message << "puts the liquid's surface at z = " << tank.fillLevel_ << " m, above the roof at z = " << roof
                << " m,";
        throw dict.errorAt(given, message.str());
    }
    tank.fillVolume_ = volumeUpTo(tank.fillLevel_);
    if (!(tank.fillVolume_ > 0))
    {
        throw dict.errorAt(given, "leaves no liquid beside the bodies,");
    }
    dict.refuseUnknown();
    return tank;
}

double Tank::thickness() const
{
    return emptyDirection_ < 0 ? 1 : box_.sizes()[emptyDirection_];
}

double Tank::distanceToWall(const Vec& X) const
{
    double distance = -distanceToBox(box_, directions_, X);
    for (const auto& body : bodies_)
    {
        distance = std::min(distance, body->signedDistance(X));
    }
    return distance;
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
