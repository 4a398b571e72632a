// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/areaOfDisc.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace slosh
{

double areaOfDisc(double radius, const Vec2& low, const Vec2& high)
{
    const double R = radius;
    const Vec2 from = low.cwiseMax(-R).cwiseMin(R), to = high.cwiseMax(-R).cwiseMin(R);
    const auto half = [&](double x) { return std::sqrt(std::max(0.0, (R - x) * (R + x))); }; // of the chord at x
    const auto underArc = [&](double x) { return (x * half(x) + R * R * std::asin(x / R)) / 2; };
    // Between these either the arc or the rectangle bounds the chord, above and below.
    const auto within = [&](double x) { return std::clamp(x, from.x(), std::max(from.x(), to.x())); };
    std::array<double, 6> ends = {
        from.x(), to.x(), within(-half(from.y())), within(half(from.y())), within(-half(to.y())), within(half(to.y()))};
    std::sort(ends.begin(), ends.end());
    double area = 0;
    for (std::size_t k = 0; k + 1 < ends.size(); ++k)
    {
        const double width = ends[k + 1] - ends[k], arc = underArc(ends[k + 1]) - underArc(ends[k]);
        const double chord = half((ends[k] + ends[k + 1]) / 2);
        if (std::min(to.y(), chord) > std::max(from.y(), -chord))
        {
            area += (to.y() < chord ? to.y() * width : arc) - (from.y() > -chord ? from.y() * width : -arc);
        }
    }
    return area;
}

} // namespace slosh
