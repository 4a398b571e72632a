// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/Prism.hpp"

#include "dictionary/Dictionary.hpp"

#include <algorithm>
#include <cmath>

namespace slosh
{

Prism::Prism(Polygon section, std::array<int, 2> axes, double low, double high, bool isSlice)
    : section_(std::move(section)), axes_(axes), low_(low), high_(high), isSlice_(isSlice)
{
}

Prism Prism::read(const Dictionary& dict, const std::string& plane)
{
    const std::string section = dict.choice("section", {"xz", "yz", "xy"}, "section");
    if (plane != "none" && section != plane)
    {
        throw dict.errorAt("section",
                           "is " + section + " in a scene in the plane " + plane + ": in 2D the two must be the same,");
    }
    const std::vector<double> extent = dict.scalars("extent", unit::metre);
    if (extent.size() != 2 || !(extent[1] > extent[0]))
    {
        throw dict.errorAt("extent", "must be two numbers that rise, (from to), in m; it is not:");
    }
    std::vector<Vec2> corners = dict.planePoints("polygon", unit::metre);
    if (const std::string fault = Polygon::fault(corners); !fault.empty())
    {
        throw dict.errorAt("polygon", fault);
    }
    const std::array<int, 2> axes = {section == "yz" ? 1 : 0, section == "xy" ? 1 : 2};
    return {Polygon(std::move(corners)), axes, extent[0], extent[1], plane != "none"};
}

Vec Prism::point(const Vec2& x, double along) const
{
    Vec X;
    X[axes_[0]] = x[0];
    X[axes_[1]] = x[1];
    X[this->along()] = along;
    return X;
}

NearestSurface Prism::nearestSurface(const Vec& X) const
{
    const NearestSide side = section_.nearest(inSection(X));
    NearestSurface nearest{side.distance, point(side.normal, 0)};
    if (isSlice_)
    {
        return nearest;
    }
    const double below = low_ - X[along()], above = X[along()] - high_;
    const double beyond = std::max(below, above);
    const Vec end = (above >= below ? 1 : -1) * Vec::Unit(along());
    if (beyond > 0 && side.distance > 0)
    {
        const Vec away = side.distance * nearest.normal + beyond * end;
        return {away.norm(), away.normalized()};
    }
    return beyond > side.distance ? NearestSurface{beyond, end} : nearest;
}

double Prism::volumeInside(const BoundingBox& box) const
{
    const double length = std::min(high_, box.max()[along()]) - std::max(low_, box.min()[along()]);
    return box.isEmpty() || length <= 0 ? 0 : length * section_.areaInside(inSection(box.min()), inSection(box.max()));
}

} // namespace slosh
