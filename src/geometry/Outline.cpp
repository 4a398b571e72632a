// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/Outline.hpp"

#include "geometry/DrawnSection.hpp"

namespace slosh
{

Outline outlineOf(const DrawnSection& section, const std::vector<double>& places)
{
    const int n = static_cast<int>(section.polygon.corners().size());
    Outline outline;
    for (const double at : places)
    {
        const int first = static_cast<int>(outline.corners.size());
        for (int i = 0; i < n; ++i)
        {
            outline.corners.push_back(section.point(section.polygon.corner(i), at));
            outline.edges.emplace_back(first + i, first + (i + 1) % n);
            if (first > 0)
            {
                outline.edges.emplace_back(i, first + i);
            }
        }
    }
    return outline;
}

} // namespace slosh
