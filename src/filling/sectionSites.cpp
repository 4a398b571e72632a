// SPDX-License-Identifier: GPL-3.0-or-later
#include "filling/sectionSites.hpp"

#include "filling/packSection.hpp"
#include "filling/wallLayers.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace slosh
{

namespace
{

/// A cell of the lattice in or near a polygon.
struct Cell
{
    Vec2 centre;
    double outside; ///< the polygon, [m]
    double turn;    ///< of its row, in [0, 1)
};

/// About `count` cells, the deepest ones. Of those as deep as each other, along a side at 45 degrees, some rows stay
/// and some go, scattered evenly; those of one row stay or go together, so that what is symmetric stays so.
std::vector<Vec2> deepest(std::vector<Cell> cells, double count, double dx)
{
    const auto isDeeper = [&](const Cell& a, const Cell& b)
    {
        const double apart = std::round((a.outside - b.outside) / (1e-6 * dx));
        return apart != 0 ? apart < 0 : a.turn < b.turn;
    };
    std::stable_sort(cells.begin(), cells.end(), isDeeper);
    const auto off = [&](std::size_t k) { return std::abs(static_cast<double>(k) - count); };
    std::size_t best = 0;
    for (std::size_t n = 1; n <= cells.size(); ++n)
    {
        const bool isCut = n == cells.size() || isDeeper(cells[n - 1], cells[n]);
        best = isCut && off(n) < off(best) ? n : best;
    }
    std::vector<Vec2> chosen;
    for (std::size_t i = 0; i < best; ++i)
    {
        chosen.push_back(cells[i].centre);
    }
    return chosen;
}

/// The points of a section: the first `below` are below the still surface (all of a section that lies flat).
struct SectionPoints
{
    std::vector<Vec2> inside, wall;
    std::size_t below = 0;
};

SectionPoints fillSection(const Tank& tank, const DrawnSection& section, const Lattice& lattice)
{
    const auto& [axes, heights, wallLayers] = lattice;
    const Polygon& polygon = section.polygon;
    const LatticeAxis& across = axes[section.axes[0]];
    const LatticeAxis& up = axes[section.axes[1]];
    const bool isUpright = section.axes[1] == 2;
    const double level = isUpright ? tank.fill().level() : polygon.high().y();
    const double area = across.spacing * up.spacing, dx = std::sqrt(area);
    std::vector<Cell> below, above;
    for (int j = up.first + wallLayers; j < up.last - wallLayers; ++j)
    {
        const double y = isUpright ? heights[j - up.first] : up.centre(j);
        std::vector<Cell>& cells = y < level ? below : above;
        const double turn = std::fmod(j * std::numbers::phi, 1);
        for (int i = across.first + wallLayers; i < across.last - wallLayers; ++i)
        {
            const Vec2 x(across.centre(i), y);
            if (const double outside = polygon.nearest(x).distance; outside < dx / 2)
            {
                cells.push_back({x, outside, turn});
            }
        }
    }
    const double liquidArea = polygon.areaInside(polygon.low(), Vec2(polygon.high().x(), level));
    SectionPoints points;
    points.inside = deepest(below, liquidArea / area, dx);
    points.below = points.inside.size();
    const std::vector<Vec2> rest = deepest(above, (polygon.area() - liquidArea) / area, dx);
    points.inside.insert(points.inside.end(), rest.begin(), rest.end());
    if (wallLayers > 0)
    {
        points.wall = slosh::wallLayers(polygon, dx, wallLayers);
        // A tank that is full has no surface.
        const double surface = isUpright && !above.empty() ? level : std::numeric_limits<double>::infinity();
        packSection(polygon, dx, surface, points.wall, points.inside);
    }
    return points;
}

} // namespace

ParticleSites sectionSites(const Tank& tank, const DrawnSection& section, const Lattice& lattice)
{
    const SectionPoints points = fillSection(tank, section, lattice);
    const LatticeAxis& along = lattice.axes[section.along()];
    const int ends = section.along() == tank.emptyDirection() ? 0 : lattice.wallLayers;
    // What lies below the surface stays liquid though packing may have lifted it a little.
    const bool isCounted = section.axes[1] == 2 && tank.fill().fromWallToWall();
    ParticleSites sites;
    for (int k = along.first; k < along.last; ++k)
    {
        const double at = section.along() == 2 ? lattice.heights[k - along.first] : along.centre(k);
        const bool isEnd = k < along.first + ends || k >= along.last - ends;
        for (const Vec2& x : points.wall)
        {
            sites.wall.push_back(section.point(x, at));
        }
        for (std::size_t i = 0; i < points.inside.size(); ++i)
        {
            const Vec X = section.point(points.inside[i], at);
            if (isEnd || isInBody(tank, X))
            {
                sites.wall.push_back(X);
            }
            else if (i < points.below && (isCounted || tank.fill().contains(X)))
            {
                sites.liquid.push_back(X);
            }
        }
    }
    return sites;
}

} // namespace slosh
