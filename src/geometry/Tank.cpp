// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/Tank.hpp"

#include "dictionary/Dictionary.hpp"
#include "geometry/Box.hpp"
#include "geometry/shapeTypes.hpp"
#include "geometry/volumeByQuadrature.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace slosh
{

namespace
{

namespace tankProperties
{

constexpr Key plane{
    .name = "plane",
    .otherwise = "none",
    .example = "yz",
    .sentence =
        "plane of a 2D scene; the extent of the other direction is the thickness for volumes, masses and forces",
    .options = [] {
        return Options{{"xz"}, {"yz"}, {"none", "3D"}};
    }};
constexpr Key type{.name = "type", .otherwise = "box", .options = [] { return optionsOf(wallTypes()); }};
constexpr Key body{.name = "baffle", .entries = bodyKeys, .anyName = true};
constexpr Key geometry{
    .name = "geometry",
    .leftOut = "none",
    .sentence = "bodies fixed in the tank; each at least as thick as the kernel's support, so that liquid on opposite "
                "sides does not interact; bounding boxes must not overlap",
    .entries = [] { return Keys{body}; }};

} // namespace tankProperties

Shapes readBodies(const Dictionary& geometry, const Shape& walls)
{
    const BoundingBox tank = walls.bounds();
    Shapes bodies;
    for (const auto& name : geometry.keys())
    {
        const Dictionary dict = geometry.dict(name);
        auto body = readBody({dict, name, walls.directions(), tank});
        if (!overlap(body->bounds(), tank) || volumeOfBoth(walls, *body, tank) <= 0)
        {
            throw geometry.errorAt(name, "lies outside the tank");
        }
        const BoundingBox inside = body->bounds().intersection(tank);
        for (const auto& other : bodies)
        {
            if (overlap(inside, other->bounds()))
            {
                throw geometry.errorAt(name, "overlaps '" + other->name() + "'");
            }
        }
        // What sticks out of the tank is in the wall already.
        bodies.push_back(body->fillsBounds() ? std::make_shared<Box>(name, inside, walls.directions()) : body);
    }
    return bodies;
}

} // namespace

Keys tankPropertiesKeys()
{
    return joined({tankProperties::plane, tankProperties::type}, joined(fillKeys(), {tankProperties::geometry}));
}

Tank Tank::read(const Dictionary& dict)
{
    const ShapeType& type = choose(dict, tankProperties::type, wallTypes(), "tank type");
    const std::string plane = dict.choice(tankProperties::plane, "plane");
    const std::vector<int> directions = plane == "none" ? std::vector{0, 1, 2} : std::vector{plane == "xz" ? 0 : 1, 2};
    auto walls = type.read({dict, std::string(type.name), directions, std::nullopt});
    Shapes bodies = readBodies(dict.dictOr(tankProperties::geometry), *walls);
    Fill fill = Fill::read(dict, *walls, bodies);
    dict.refuseIdle(tankPropertiesKeys());
    return {std::move(walls), std::move(bodies), std::move(fill)};
}

Tank::Tank(std::shared_ptr<const Shape> walls, Shapes bodies, Fill fill)
    : walls_(std::move(walls)), isBox_(walls_->fillsBounds()),
      emptyDirection_(directions().size() == 3 ? -1 : 1 - directions().front()), box_(walls_->bounds()),
      low_(box_.min()), high_(box_.max()), bodies_(std::move(bodies)), fill_(std::move(fill))
{
    if (emptyDirection_ >= 0)
    {
        low_[emptyDirection_] = -std::numeric_limits<double>::infinity();
        high_[emptyDirection_] = std::numeric_limits<double>::infinity();
    }
}

double Tank::thickness() const
{
    return emptyDirection_ < 0 ? 1 : box_.sizes()[emptyDirection_];
}

bool Tank::inBody(const Vec& X) const
{
    return std::any_of(bodies_.begin(), bodies_.end(), [&](const auto& body) { return body->contains(X); });
}

NearestWall Tank::nearestWall(const Vec& X) const
{
    NearestWall nearest{walls_->nearestSurface(X)};
    nearest.distance *= -1; // the liquid is inside
    nearest.normal *= -1;
    for (std::size_t k = 0; k < bodies_.size(); ++k)
    {
        if (const NearestSurface surface = bodies_[k]->nearestSurface(X); surface.distance < nearest.distance)
        {
            nearest = {surface, k + 1};
        }
    }
    return nearest;
}

std::vector<std::string> Tank::partNames() const
{
    std::vector<std::string> names = {"walls"};
    for (const auto& body : bodies_)
    {
        names.push_back(body->name());
    }
    return names;
}

std::pair<double, double> Tank::verticalExtent(const Vec& X) const
{
    if (isBox_)
    {
        return {box_.min().z(), box_.max().z()};
    }
    const auto chords = walls_->chords(2, X);
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
        const double volume = walls_->volumeInside(part);
        sum += f(fillDepth() * (layers - k - 0.5) / layers) * (volume - below);
        below = volume;
    }
    return sum / below;
}

std::optional<BoundingBox> Tank::boxUnderSurface() const
{
    // Just below: at the level itself there may be a corner, or the roof.
    auto box = walls_->rectangleAt(fill_.level() - 1e-9 * fillDepth());
    if (box)
    {
        box->max().z() = fill_.level();
    }
    return box;
}

bool Tank::liquidIsBox() const
{
    const auto box = boxUnderSurface();
    BoundingBox below = box_;
    below.max().z() = fill_.level();
    return box && (isBox_ || std::abs(walls_->volumeInside(below) / box->volume() - 1) < 1e-6);
}

std::vector<double> Tank::naturalFrequencies(double gravity, int count) const
{
    const auto box = boxUnderSurface();
    if (!box)
    {
        return {};
    }
    const double pi = std::numbers::pi;
    const double L = box->sizes()[directions()[0]];
    const double B = dim() == 3 ? box->sizes()[directions()[1]] : 0;
    std::vector<double> omega;
    for (int m = 0; m <= count; ++m)
    {
        for (int n = 0; n <= (dim() == 3 ? count : 0); ++n)
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
