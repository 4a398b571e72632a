// SPDX-License-Identifier: GPL-3.0-or-later
#include "filling/wallLayers.hpp"

#include "filling/PointGrid.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace slosh
{

namespace
{

/// Points evenly spaced along a line through `nodes`, about `dx` apart: the first node, not the last.
void addEvenly(const std::vector<Vec2>& nodes, double dx, std::vector<Vec2>& points)
{
    double length = 0;
    for (std::size_t k = 0; k + 1 < nodes.size(); ++k)
    {
        length += (nodes[k + 1] - nodes[k]).norm();
    }
    const double step = length / std::max(1.0, std::round(length / dx));
    double next = 0; // along the line from nodes[k]
    double left = length - step / 2;
    for (std::size_t k = 0; k + 1 < nodes.size(); ++k)
    {
        const Vec2 along = nodes[k + 1] - nodes[k];
        const double side = along.norm();
        for (; next < side && left > 0; next += step, left -= step)
        {
            points.emplace_back(nodes[k] + next / side * along);
        }
        next -= side;
    }
}

/// The polygon moved outward by `distance`: its row of points.
std::vector<Vec2> rowAt(const Polygon& liquid, double distance, double dx)
{
    const auto n = static_cast<std::ptrdiff_t>(liquid.corners().size());
    std::vector<Vec2> mitred;
    std::vector<std::ptrdiff_t> sharp;
    for (std::ptrdiff_t i = 0; i < n; ++i)
    {
        const Vec2 before = liquid.outward(i - 1), after = liquid.outward(i);
        const double cosine = before.dot(after);
        mitred.emplace_back(liquid.corner(i) + distance / (1 + cosine) * (before + after));
        if (cosine < std::cos(std::numbers::pi / 6))
        {
            sharp.push_back(i);
        }
    }
    if (sharp.empty())
    {
        sharp.push_back(0);
    }
    std::vector<Vec2> points;
    for (std::size_t k = 0; k < sharp.size(); ++k)
    {
        const std::ptrdiff_t end = k + 1 < sharp.size() ? sharp[k + 1] : sharp.front() + n;
        std::vector<Vec2> nodes;
        for (std::ptrdiff_t i = sharp[k]; i <= end; ++i)
        {
            nodes.push_back(mitred[i % n]);
        }
        addEvenly(nodes, dx, points);
    }
    return points;
}

} // namespace

std::vector<Vec2> wallLayers(const Polygon& liquid, double dx, int layers)
{
    std::vector<Vec2> wall;
    PointGrid grid(dx / 2);
    const auto isFree = [&](const Vec2& x)
    {
        bool free = true;
        grid.forEachNear(x, [&](std::size_t i) { free = free && (wall[i] - x).norm() >= dx / 2; });
        return free;
    };
    for (int k = 0; k < layers; ++k)
    {
        const double distance = (k + 0.5) * dx;
        for (const Vec2& x : rowAt(liquid, distance, dx))
        {
            const double from = liquid.nearest(x).distance;
            if (from > distance - 1e-9 * dx && from < layers * dx && isFree(x))
            {
                grid.add(x, wall.size());
                wall.push_back(x);
            }
        }
    }
    return wall;
}

} // namespace slosh
