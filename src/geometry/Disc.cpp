// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/Disc.hpp"

#include "dictionary/Dictionary.hpp"
#include "geometry/areaOfDisc.hpp"
#include "geometry/shapeTypes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace slosh
{

namespace
{

namespace disc
{

constexpr Key centre{
    .name = "centre", .example = "(0 0 0.31)", .unit = unit::metre, .sentence = "the empty direction is ignored"};
constexpr Key radius{.name = "radius", .example = "0.31", .unit = unit::metre, .range = positive};

} // namespace disc

} // namespace

Keys discKeys()
{
    return {disc::centre, disc::radius, extentKey()};
}

Disc::Disc(const Vec& centre, double radius, const std::vector<int>& plane, double low, double high)
    : Shape("disc", plane), centre_(centre), radius_(radius)
{
    bounds_ = BoundingBox(Vec::Constant(low), Vec::Constant(high));
    for (const int d : plane)
    {
        bounds_.min()[d] = centre[d] - radius;
        bounds_.max()[d] = centre[d] + radius;
    }
}

Vec2 Disc::fromCentre(const Vec& X) const
{
    const int a = directions()[0], b = directions()[1];
    return {X[a] - centre_[a], X[b] - centre_[b]};
}

NearestSurface Disc::nearestSurface(const Vec& X) const
{
    const Vec2 from = fromCentre(X);
    const double r = from.norm();
    Vec normal = Vec::Unit(directions()[0]); // in the centre any is as good
    if (r > 0)
    {
        normal[directions()[0]] = from.x() / r;
        normal[directions()[1]] = from.y() / r;
    }
    return {r - radius_, normal};
}

double Disc::volumeInside(const BoundingBox& box) const
{
    const BoundingBox part = bounds_.intersection(box);
    return part.isEmpty() ? 0
                          : part.sizes()[3 - directions()[0] - directions()[1]] *
                                areaOfDisc(radius_, fromCentre(part.min()), fromCentre(part.max()));
}

std::vector<std::pair<double, double>> Disc::chords(int along, const Vec& X) const
{
    const int axis = along == directions()[0] ? 0 : 1;
    const double off = fromCentre(X)[1 - axis];
    if (std::abs(off) > radius_)
    {
        return {};
    }
    const double half = std::sqrt((radius_ - off) * (radius_ + off));
    return {{centre_[along] - half, centre_[along] + half}};
}

DrawnSection Disc::polygon(int sides) const
{
    const double pi = std::numbers::pi, R = radius_ * std::sqrt(2 * pi / sides / std::sin(2 * pi / sides));
    const int a = directions()[0], b = directions()[1];
    std::vector<Vec2> corners;
    for (int k = 0; k < sides; ++k)
    {
        const double angle = 2 * pi * (k + 0.5) / sides; // a side, not a corner, lowest: what is symmetric stays so
        corners.emplace_back(centre_[a] + R * std::cos(angle), centre_[b] + R * std::sin(angle));
    }
    return {Polygon(std::move(corners)), {a, b}};
}

Outline Disc::outline() const
{
    const DrawnSection section = polygon(128);
    return outlineOf(section, {bounds_.center()[section.along()]});
}

std::optional<DrawnSection> Disc::section(double dx) const
{
    // A side's middle is R (pi/n)^2/2 from its arc at most.
    const int sides = 4 * static_cast<int>(std::ceil(std::numbers::pi / 4 * std::sqrt(50 * radius_ / dx)));
    return polygon(std::max(32, sides));
}

std::shared_ptr<const Shape> readDisc(const ShapeSetting& setting)
{
    const Dictionary& dict = setting.dict;
    if (setting.directions.size() == 3)
    {
        throw dict.errorAt("type", "is disc, which is a shape of 2D; expected plane xz or plane yz");
    }
    const Vec centre = dict.vector(disc::centre);
    const double radius = dict.scalar(disc::radius);
    const auto [low, high] = readExtent(dict);
    return std::make_shared<Disc>(centre, radius, setting.directions, low, high);
}

} // namespace slosh
