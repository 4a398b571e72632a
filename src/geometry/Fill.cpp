// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/Fill.hpp"

#include "dictionary/Dictionary.hpp"
#include "geometry/shapeTypes.hpp"
#include "geometry/volumeByQuadrature.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace slosh
{

namespace
{

namespace tankProperties
{

constexpr Key fillDepth{
    .name = "fillDepth",
    .example = "0.155",
    .unit = unit::metre,
    .range = positive,
    .sentence = "fill depth above the bottom; alternatives: fillLevel, fillVolume, liquid"};
constexpr Key fillLevel{
    .name = "fillLevel",
    .example = "0.155",
    .unit = unit::metre,
    .sentence = "z of the still water level",
    .alternative = true};
constexpr Key fillVolume{
    .name = "fillVolume",
    .example = "0.1426",
    .unit = unit::cubicMetre,
    .range = positive,
    .sentence = "of the liquid, without bodies",
    .alternative = true};
constexpr Key column{
    .name = "column",
    .example = "type searchableBox; min (-0.5 -0.46 0); max (0.5 -0.2 0.3);",
    .entries = noKeys,
    .anyName = true};
constexpr Key drop{
    .name = "drop",
    .example = "type searchableSphere; centre (0 0.1 0.4); radius 0.05;",
    .entries = noKeys,
    .anyName = true};
constexpr Key liquid{
    .name = "liquid",
    .sentence = "regions of liquid wholly inside the tank: a dam, a drop, a patch; each has the entries of a body in "
                "geometry; the pressure is hydrostatic below its top",
    .entries =
        [] {
            return Keys{column, drop};
        },
    .alternative = true};

} // namespace tankProperties

/// The part of the tank below z = level.
BoundingBox below(BoundingBox tank, double level)
{
    tank.max().z() = std::clamp(level, tank.min().z(), tank.max().z());
    return tank;
}

double volumeUpTo(double level, const Shape& tank, const Shapes& bodies)
{
    const BoundingBox part = below(tank.bounds(), level);
    double volume = tank.volumeInside(part);
    for (const auto& body : bodies)
    {
        volume -= volumeOfBoth(tank, *body, part);
    }
    return volume;
}

/// The level at which the volume is in the tank: it rises with the level, so bisection to the last bit.
double levelOfVolume(double volume, const Shape& tank, const Shapes& bodies)
{
    double low = tank.bounds().min().z(), high = tank.bounds().max().z();
    for (double middle = (low + high) / 2; middle > low && middle < high; middle = (low + high) / 2)
    {
        (volumeUpTo(middle, tank, bodies) < volume ? low : high) = middle;
    }
    return high;
}

/// The one of the entries that is set.
Key keyOfFill(const Dictionary& dict)
{
    Key given;
    for (const Key& key : fillKeys())
    {
        if (dict.has(key))
        {
            if (!given.name.empty())
            {
                throw dict.errorAt(key, "and " + std::string(given.name) + " are both set; expected one of them");
            }
            given = key;
        }
    }
    if (given.name.empty())
    {
        dict.scalar(tankProperties::fillDepth); // says that it is missing
    }
    return given;
}

Shapes readRegions(const Dictionary& liquid, const Shape& walls, const Shapes& bodies)
{
    const BoundingBox tank = walls.bounds();
    Shapes regions;
    for (const auto& name : liquid.keys())
    {
        const Dictionary dict = liquid.dict(name);
        auto region = readBody({dict, name, walls.directions(), tank});
        const BoundingBox bounds = region->bounds();
        const double slack = 1e-9 * tank.sizes().maxCoeff();
        if ((bounds.min().array() < tank.min().array() - slack).any() ||
            (bounds.max().array() > tank.max().array() + slack).any())
        {
            throw liquid.errorAt(name, "extends beyond the tank; expected it wholly inside");
        }
        if (walls.volumeInside(bounds) < bounds.volume() * (1 - 1e-6))
        {
            throw liquid.errorAt(name, "or the box around it extends beyond the tank; expected it wholly inside");
        }
        for (const auto& other : regions)
        {
            if (overlap(bounds, other->bounds()))
            {
                throw liquid.errorAt(name, "overlaps '" + other->name() + "'");
            }
        }
        for (const auto& body : bodies)
        {
            if (overlap(bounds, body->bounds()))
            {
                throw liquid.errorAt(name, "overlaps the body '" + body->name() + "'");
            }
        }
        regions.push_back(std::move(region));
    }
    if (regions.empty())
    {
        throw errorIn(placeIn(liquid.name(), liquid.line()), "liquid has no region; expected at least one");
    }
    return regions;
}

} // namespace

Keys fillKeys()
{
    using namespace tankProperties;
    return {fillDepth, fillLevel, fillVolume, liquid};
}

Fill Fill::read(const Dictionary& dict, const Shape& tank, const Shapes& bodies)
{
    const double bottom = tank.bounds().min().z(), roof = tank.bounds().max().z();
    const Key given = keyOfFill(dict);
    Fill fill;
    if (given.name == tankProperties::liquid.name)
    {
        fill.regions_ = readRegions(dict.dict(given), tank, bodies);
        fill.level_ = bottom;
        for (const auto& region : fill.regions_)
        {
            fill.level_ = std::max(fill.level_, region->bounds().max().z());
            fill.volume_ += region->volumeInside(region->bounds());
        }
        return fill;
    }
    if (given.name == tankProperties::fillVolume.name)
    {
        const double volume = dict.scalar(given);
        if (const double most = volumeUpTo(roof, tank, bodies); volume > most * (1 + 1e-12))
        {
            std::ostringstream message;
            message << "is " << volume << " m^3; expected at most " << most << " m^3, the volume of the tank";
            throw dict.errorAt(given, message.str());
        }
        fill.level_ = levelOfVolume(volume, tank, bodies);
    }
    else if (given.name == tankProperties::fillDepth.name)
    {
        fill.level_ = bottom + dict.scalar(given);
    }
    else
    {
        fill.level_ = dict.scalar(given);
        if (!(fill.level_ > bottom))
        {
            std::ostringstream message;
            message << "is " << fill.level_ << " m; expected a level above the tank's bottom, z = " << bottom << " m";
            throw dict.errorAt(given, message.str());
        }
    }
    if (fill.level_ > roof + 1e-12 * (std::abs(roof) + roof - bottom))
    {
        std::ostringstream message;
        message << "puts the liquid's surface at z = " << fill.level_ << " m, above the roof at z = " << roof << " m";
        throw dict.errorAt(given, message.str());
    }
    fill.volume_ = volumeUpTo(fill.level_, tank, bodies);
    if (!(fill.volume_ > 0))
    {
        throw dict.errorAt(given, "leaves no space for liquid beside the bodies");
    }
    return fill;
}

bool Fill::hasOneSurface() const
{
    return std::all_of(
        regions_.begin(), regions_.end(), [&](const auto& region) { return region->bounds().max().z() == level_; }
    );
}

double Fill::depthAt(const Vec& X) const
{
    if (fromWallToWall())
    {
        return std::max(0.0, level_ - X.z());
    }
    for (const auto& region : regions_)
    {
        if (region->signedDistance(X) < 0)
        {
            return region->bounds().max().z() - X.z();
        }
    }
    return 0;
}

} // namespace slosh
