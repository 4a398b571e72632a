// SPDX-License-Identifier: GPL-3.0-or-later
#include "filling/packSection.hpp"

#include "base/parallel.hpp"
#include "filling/PointGrid.hpp"
#include "geometry/Polygon.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace slosh
{

namespace
{

/// W'(r)/r of a Gaussian in 2D, [1/m^4].
double gradFactor(double r, double h)
{
    const double h2 = h * h;
    return -2 / (std::numbers::pi * h2 * h2) * std::exp(-r * r / h2);
}

/// Those within `reach` of each of the first near.size() points.
void listNeighbours(const std::vector<Vec2>& x, double reach, std::vector<std::vector<std::size_t>>& near)
{
    PointGrid grid(reach);
    for (std::size_t b = 0; b < x.size(); ++b)
    {
        grid.add(x[b], b);
    }
    for (std::size_t a = 0; a < near.size(); ++a)
    {
        near[a].clear();
        grid.forEachNear(
            x[a],
            [&](std::size_t b)
            {
                if (b != a && (x[a] - x[b]).squaredNorm() < reach * reach)
                {
                    near[a].push_back(b);
                }
            }
        );
    }
}

} // namespace

void packSection(
    const Polygon& section, double dx, double level, const std::vector<Vec2>& wall, std::vector<Vec2>& inside
)
{
    const double h = 1.23 * dx, reach = 3 * h;
    // Those that move first, then those that stay but are felt.
    std::vector<std::size_t> moving;
    std::vector<Vec2> x, still = wall;
    for (std::size_t i = 0; i < inside.size(); ++i)
    {
        const double depth = -section.nearest(inside[i]).distance;
        if (depth < 6 * dx)
        {
            moving.push_back(i);
            x.push_back(inside[i]);
        }
        else if (depth < 6 * dx + reach + dx)
        {
            still.push_back(inside[i]);
        }
    }
    x.insert(x.end(), still.begin(), still.end());
    // Lists hold whom a point may meet until one has moved by half the margin.
    const double margin = 0.4 * dx;
    std::vector<std::vector<std::size_t>> near(moving.size());
    std::vector<Vec2> moved = x;
    double sinceListed = margin, largest = dx;
    for (int round = 0; round < 2000 && largest > 2e-4 * dx; ++round)
    {
        if (sinceListed + largest > margin / 2)
        {
            listNeighbours(x, reach + margin, near);
            sinceListed = 0;
        }
        parallelFor(
            static_cast<std::ptrdiff_t>(moving.size()),
            [&](std::ptrdiff_t a)
            {
                Vec2 sum = Vec2::Zero();
                for (const std::size_t b : near[a])
                {
                    sum += gradFactor((x[a] - x[b]).norm(), h) * (x[a] - x[b]);
                }
                Vec2 step = -0.2 * h * h * dx * dx * sum;
                if (std::abs(x[a].y() - level) < 1.6 * dx)
                {
                    step.y() = 0;
                }
                moved[a] = x[a] + std::min(1.0, 0.1 * dx / std::max(step.norm(), 1e-300)) * step;
                // The centre of a particle is not behind a side, nor at it.
                const NearestSide side = section.nearest(moved[a]);
                moved[a] -= std::max(0.0, side.distance + dx / 4) * side.normal;
            }
        );
        largest = 0;
        for (std::size_t a = 0; a < moving.size(); ++a)
        {
            largest = std::max(largest, (moved[a] - x[a]).norm());
        }
        sinceListed += largest;
        std::copy_n(moved.begin(), moving.size(), x.begin());
    }
    for (std::size_t a = 0; a < moving.size(); ++a)
    {
        inside[moving[a]] = x[a];
    }
}

} // namespace slosh
