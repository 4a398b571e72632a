// SPDX-License-Identifier: GPL-3.0-or-later
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
    const bool isPrism = dict.choiceOr("type", "box", {"box", "prism"}, "tank type") == "prism";
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
    std::shared_ptr<const Shape> walls;
    if (isPrism)
    {
        auto prism = std::make_shared<Prism>(Prism::read(dict, plane));
        tank.box_ = prism->bounds();
        walls = prism;
        if (!prism->section().isRectangle())
        {
            tank.prism_ = prism;
        }
    }
    else
    {
        tank.box_ = readBox(dict);
    }
    if (!tank.prism_)
    {
        walls = std::make_shared<Box>("box", tank.box_, tank.directions_);
    }
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
        if (!overlap(body->bounds(), tank.box_) || walls->volumeInside(body->bounds()) <= 0)
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
    tank.fill_ = Fill::read(dict, *walls, tank.bodies_, tank.directions_);
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
    NearestSurface nearest = prism_ ? prism_->nearestSurface(X) : nearestOfBox(box_, directions_, X);
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

std::pair<double, double> Tank::verticalExtent(const Vec& X) const
{
    if (!prism_ || prism_->along() == 2)
    {
        return {box_.min().z(), box_.max().z()};
    }
    const auto chords = prism_->section().chords(1, X[prism_->axes()[0]]);
    return chords.empty() ? std::pair{box_.min().z(), box_.min().z()}
                          : std::pair{chords.front().first, chords.back().second};
}

double Tank::meanOverDepth(const std::function<double(double)>& f) const
{
    constexpr int layers = 1000;
    double sum = 0, below = 0;
    BoundingBox part = box_;
    for (int k = 0; k < layers; ++k)
    {
        part.max().z() = box_.min().z() + fillDepth() * (k + 1) / layers;
        const double volume = prism_ ? prism_->volumeInside(part) : part.volume();
        sum += f(fillDepth() * (layers - k - 0.5) / layers) * (volume - below);
        below = volume;
    }
    return sum / below;
}

std::optional<BoundingBox> Tank::boxUnderSurface() const
{
    BoundingBox box = box_;
    box.max().z() = fill_.level();
    if (!prism_)
    {
        return box;
    }
    // Just below: at the level itself there may be a corner, or the roof.
    const auto chords = prism_->section().chords(0, fill_.level() - 1e-9 * fillDepth());
    if (prism_->along() == 2 || chords.size() != 1)
    {
        return std::nullopt;
    }
    box.min()[prism_->axes()[0]] = chords.front().first;
    box.max()[prism_->axes()[0]] = chords.front().second;
    return box;
}

bool Tank::liquidIsBox() const
{
    const auto box = boxUnderSurface();
    BoundingBox below = box_;
    below.max().z() = fill_.level();
    return box && (!prism_ || std::abs(prism_->volumeInside(below) / box->volume() - 1) < 1e-6);
}

std::vector<double> Tank::naturalFrequencies(double gravity, int count) const
{
    const auto box = boxUnderSurface();
    if (!box)
    {
        return {};
    }
    const double pi = std::numbers::pi;
    const double L = box->sizes()[directions_[0]];
    const double B = dim_ == 3 ? box->sizes()[directions_[1]] : 0;
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
    omega.resize(count);
    return omega;
}

} // namespace slosh
