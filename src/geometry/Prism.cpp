// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/Prism.hpp"

#include "dictionary/Dictionary.hpp"
#include "geometry/Box.hpp"
#include "geometry/shapeTypes.hpp"

#include <algorithm>

namespace slosh
{

namespace
{

namespace prism
{

constexpr Key section{
    .name = "section", .example = "yz", .sentence = "the polygon's plane; in 2D that of the scene", .options = [] {
        return Options{{"xz"}, {"yz"}, {"xy", "3D only: an upright prism"}};
    }};
constexpr Key polygon{
    .name = "polygon",
    .example = "((-0.46 0.1) (-0.36 0) (0.36 0) (0.46 0.1) (0.46 0.62) (-0.46 0.62))",
    .unit = unit::metre,
    .sentence = "inner corners in order, clockwise or counterclockwise, in the section's axes; no two sides intersect, "
                "no corner lies on a straight line between its neighbours; a wall with liquid on both sides is at "
                "least as thick as the kernel's support"};

} // namespace prism

} // namespace

Keys prismKeys()
{
    return {prism::section, prism::polygon, extentKey()};
}

Prism::Prism(DrawnSection section, double low, double high, bool isSlice)
    : Shape("prism", isSlice ? std::vector{section.axes[0], section.axes[1]} : std::vector{0, 1, 2}),
      section_(std::move(section)), low_(low), high_(high), isSlice_(isSlice)
{
}

NearestSurface Prism::nearestSurface(const Vec& X) const
{
    const NearestSide side = section_.polygon.nearest(section_.inSection(X));
    NearestSurface nearest{side.distance, section_.point(side.normal, 0)};
    if (isSlice_)
    {
        return nearest;
    }
    const int along = section_.along();
    const double below = low_ - X[along], above = X[along] - high_;
    const double beyond = std::max(below, above);
    const Vec end = (above >= below ? 1 : -1) * Vec::Unit(along);
    if (beyond > 0 && side.distance > 0)
    {
        const Vec away = side.distance * nearest.normal + beyond * end;
        return {away.norm(), away.normalized()};
    }
    return beyond > side.distance ? NearestSurface{beyond, end} : nearest;
}

BoundingBox Prism::bounds() const
{
    return BoundingBox(section_.point(section_.polygon.low(), low_), section_.point(section_.polygon.high(), high_));
}

bool Prism::contains(const Vec& X) const
{
    const double at = X[section_.along()];
    return (isSlice_ || (at >= low_ && at <= high_)) && section_.polygon.contains(section_.inSection(X));
}

double Prism::volumeInside(const BoundingBox& box) const
{
    const int along = section_.along();
    const double length = std::min(high_, box.max()[along]) - std::max(low_, box.min()[along]);
    return box.isEmpty() || length <= 0
               ? 0
               : length * section_.polygon.areaInside(section_.inSection(box.min()), section_.inSection(box.max()));
}

std::vector<std::pair<double, double>> Prism::chords(int along, const Vec& X) const
{
    const Vec2 x = section_.inSection(X);
    if (along == section_.along())
    {
        // A point of the wall, to rounding, has the chord that touches it.
        const double slack = 1e-9 * (section_.polygon.high() - section_.polygon.low()).norm();
        if (section_.polygon.nearest(x).distance > slack)
        {
            return {};
        }
        return {{low_, high_}};
    }
    const int axis = along == section_.axes[0] ? 0 : 1;
    return section_.polygon.chords(axis, x[1 - axis]);
}

std::optional<BoundingBox> Prism::rectangleAt(double z) const
{
    const int across = section_.axes[0];
    BoundingBox box = bounds();
    const auto parts = section_.polygon.chords(0, z);
    if (section_.axes[1] != 2 || parts.size() != 1)
    {
        return std::nullopt;
    }
    box.min()[across] = parts.front().first;
    box.max()[across] = parts.front().second;
    return box;
}

Outline Prism::outline() const
{
    return outlineOf(section_, isSlice_ ? std::vector{bounds().center()[section_.along()]} : std::vector{low_, high_});
}

std::string Prism::description() const
{
    return "a prism of " + std::to_string(section_.polygon.corners().size()) + " sides";
}

std::shared_ptr<const Shape> readPrism(const ShapeSetting& setting)
{
    const Dictionary& dict = setting.dict;
    const bool isSlice = setting.directions.size() == 2;
    const std::string section = dict.choice(prism::section, "section");
    const std::array<int, 2> axes = {section == "yz" ? 1 : 0, section == "xy" ? 1 : 2};
    if (isSlice && (axes[0] != setting.directions[0] || axes[1] != setting.directions[1]))
    {
        const std::string plane = setting.directions[0] == 0 ? "xz" : "yz";
        throw dict.errorAt(prism::section, "is " + section + " and plane is " + plane + "; expected the same in 2D");
    }
    const auto [low, high] = readExtent(dict);
    std::vector<Vec2> corners = dict.planePoints(prism::polygon);
    if (const std::string fault = Polygon::fault(corners); !fault.empty())
    {
        throw dict.errorAt(prism::polygon, fault);
    }
    Polygon polygon(std::move(corners));
    const bool isBox = polygon.isRectangle();
    auto walls = std::make_shared<Prism>(DrawnSection{std::move(polygon), axes}, low, high, isSlice);
    if (isBox)
    {
        return std::make_shared<Box>("box", walls->bounds(), setting.directions);
    }
    return walls;
}

} // namespace slosh
