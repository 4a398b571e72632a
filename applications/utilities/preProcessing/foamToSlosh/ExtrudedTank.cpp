// SPDX-License-Identifier: GPL-3.0-or-later
#include "ExtrudedTank.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>

namespace slosh
{

namespace
{

using Point = Eigen::Vector2d;

constexpr double slack = 1e-9; ///< of the tank's size

double cross(const Point& a, const Point& b)
{
    return a.x() * b.y() - a.y() * b.x();
}

Point inSection(const Vec& X, int axis)
{
    return axis == 0 ? Point(X.y(), X.z()) : axis == 1 ? Point(X.x(), X.z()) : Point(X.x(), X.y());
}

double areaOf(const std::vector<Point>& polygon)
{
    double twice = 0;
    for (std::size_t k = 0; k < polygon.size(); ++k)
    {
        twice += cross(polygon[k], polygon[(k + 1) % polygon.size()]);
    }
    return twice / 2;
}

/// How far the points are from the line through those two that are farthest apart.
double widthOf(const std::vector<Point>& points)
{
    Point from = points[0], to = points[0];
    for (const Point& a : points)
    {
        for (const Point& b : points)
        {
            if ((b - a).norm() > (to - from).norm())
            {
                from = a;
                to = b;
            }
        }
    }
    double width = 0;
    for (const Point& a : points)
    {
        width = std::max(width, std::abs(cross(to - from, a - from)) / std::max((to - from).norm(), 1e-300));
    }
    return width;
}

/// The blocks along one axis: which faces are the ends, and whether all others are along it.
struct Ends
{
    double low = 0, high = 0;
    std::vector<const OuterFace*> lower, all; ///< all: both ends
};

std::optional<Ends> endsAlong(int axis, const BlockMesh& mesh, const std::vector<OuterFace>& faces, double size)
{
    Ends ends;
    const auto along = [&](int label) { return mesh.vertices[label][axis]; };
    ends.low = ends.high = along(faces[0].corners[0]);
    for (const auto& face : faces)
    {
        for (const int label : face.corners)
        {
            ends.low = std::min(ends.low, along(label));
            ends.high = std::max(ends.high, along(label));
        }
    }
    for (const auto& face : faces)
    {
        const auto lies = [&](double at)
        {
            return std::all_of(
                face.corners.begin(), face.corners.end(),
                [&](int label) { return std::abs(along(label) - at) <= slack * size; }
            );
        };
        const bool isLow = lies(ends.low);
        if (isLow || lies(ends.high))
        {
            ends.all.push_back(&face);
            if (isLow)
            {
                ends.lower.push_back(&face);
            }
            continue;
        }
        std::vector<Point> seen;
        for (const int label : face.corners)
        {
            seen.push_back(inSection(mesh.vertices[label], axis));
        }
        if (widthOf(seen) > slack * size)
        {
            return std::nullopt;
        }
    }
    return ends;
}

/// The outline of faces: their edges that no two share, one after the other. Throws where that is not one polygon.
std::vector<int> outlineOf(const std::vector<const OuterFace*>& faces, const std::string& file)
{
    std::map<std::pair<int, int>, int> edges;
    for (const auto* face : faces)
    {
        for (std::size_t k = 0; k < face->corners.size(); ++k)
        {
            const int a = face->corners[k], b = face->corners[(k + 1) % face->corners.size()];
            ++edges[{std::min(a, b), std::max(a, b)}];
        }
    }
    std::map<int, std::vector<int>> next;
    for (const auto& [edge, count] : edges)
    {
        if (count == 1)
        {
            next[edge.first].push_back(edge.second);
            next[edge.second].push_back(edge.first);
        }
    }
    std::vector<int> outline;
    if (std::all_of(next.begin(), next.end(), [](const auto& corner) { return corner.second.size() == 2; }))
    {
        int before = -1, at = next.begin()->first;
        do
        {
            outline.push_back(at);
            const auto& neighbours = next[at];
            const int following = neighbours[0] == before ? neighbours[1] : neighbours[0];
            before = at;
            at = following;
        } while (at != outline.front());
    }
    if (outline.size() != next.size())
    {
        throw errorIn(
            file, "the section of the blocks is not one polygon; expected no hole, no baffle, no parts that touch in "
                  "corners only, and blocks that share their vertices"
        );
    }
    return outline;
}

/// Without corners on straight sides, counter-clockwise, the lowest of the leftmost first.
std::vector<Point> tidied(std::vector<Point> polygon, double size)
{
    for (std::size_t k = 0; k < polygon.size();)
    {
        const std::size_t n = polygon.size();
        const bool straight = widthOf({polygon[(k + n - 1) % n], polygon[k], polygon[(k + 1) % n]}) <= slack * size;
        if (straight)
        {
            polygon.erase(polygon.begin() + static_cast<std::ptrdiff_t>(k));
            k = 0;
        }
        else
        {
            ++k;
        }
    }
    if (areaOf(polygon) < 0)
    {
        std::reverse(polygon.begin(), polygon.end());
    }
    std::rotate(
        polygon.begin(),
        std::min_element(
            polygon.begin(), polygon.end(),
            [](const Point& a, const Point& b) { return std::pair(a.x(), a.y()) < std::pair(b.x(), b.y()); }
        ),
        polygon.end()
    );
    return polygon;
}

} // namespace

std::vector<OuterFace> outerFaces(const BlockMesh& mesh)
{
    std::map<std::set<int>, const BlockMesh::Patch*> patches;
    for (const auto& patch : mesh.patches)
    {
        for (const auto& face : patch.faces)
        {
            patches[std::set<int>(face.begin(), face.end())] = &patch;
        }
    }
    std::map<std::set<int>, std::pair<int, BlockMesh::Face>> found;
    for (const auto& block : mesh.blocks)
    {
        for (const auto& face : BlockMesh::facesOf(block))
        {
            auto& [count, corners] = found[std::set<int>(face.begin(), face.end())];
            ++count;
            corners = face;
        }
    }
    std::vector<OuterFace> faces;
    for (auto& [labels, face] : found)
    {
        auto& [count, corners] = face;
        corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
        if (corners.size() > 1 && corners.front() == corners.back())
        {
            corners.pop_back();
        }
        if (count == 1 && corners.size() > 2)
        {
            const auto patch = patches.find(labels);
            const bool isNamed = patch != patches.end();
            faces.push_back(
                {corners, isNamed ? patch->second->name : mesh.defaultName,
                 isNamed ? patch->second->type : mesh.defaultType}
            );
        }
    }
    return faces;
}

ExtrudedTank ExtrudedTank::of(const BlockMesh& mesh)
{
    const std::vector<OuterFace> faces = outerFaces(mesh);
    BoundingBox box;
    for (const auto& face : faces)
    {
        for (const int label : face.corners)
        {
            box.extend(mesh.vertices[label]);
        }
    }
    if (faces.empty())
    {
        throw errorIn(mesh.file, "the blocks have no outer faces; expected those of a tank");
    }
    const double size = box.sizes().maxCoeff();
    const auto isEmpty = [](const OuterFace& face) { return face.type == "empty"; };
    const auto nEmpty = std::count_if(faces.begin(), faces.end(), isEmpty);
    bool anyPrism = false;
    for (const int axis : {1, 0, 2})
    {
        const std::optional<Ends> ends = endsAlong(axis, mesh, faces, size);
        if (!ends)
        {
            continue;
        }
        anyPrism = true;
        const bool allEmpty =
            std::all_of(ends->all.begin(), ends->all.end(), [&](const auto* face) { return isEmpty(*face); });
        if (nEmpty > 0 && !(allEmpty && nEmpty == std::ssize(ends->all)))
        {
            continue;
        }
        ExtrudedTank tank;
        tank.axis = axis;
        tank.low = ends->low;
        tank.high = ends->high;
        tank.flat = nEmpty > 0;
        for (const int label : outlineOf(ends->lower, mesh.file))
        {
            tank.polygon.push_back(inSection(mesh.vertices[label], axis));
        }
        tank.polygon = tidied(std::move(tank.polygon), size);
        return tank;
    }
    throw errorIn(
        mesh.file, anyPrism ? "the empty faces are not the two ends of the tank; expected both ends, and no others"
                            : "the blocks are no prism along x, y or z; expected faces along that axis, and two ends"
    );
}

BoundingBox ExtrudedTank::bounds() const
{
    BoundingBox box;
    for (const Point& corner : polygon)
    {
        for (const double along : {low, high})
        {
            box.extend(
                axis == 0   ? Vec(along, corner.x(), corner.y())
                : axis == 1 ? Vec(corner.x(), along, corner.y())
                            : Vec(corner.x(), corner.y(), along)
            );
        }
    }
    return box;
}

double ExtrudedTank::area() const
{
    return areaOf(polygon);
}

bool ExtrudedTank::isBox() const
{
    return polygon.size() == 4 && area() >= (1 - slack) * bounds().volume() / (high - low);
}

bool ExtrudedTank::contains(const Vec& X) const
{
    const double reach = slack * bounds().sizes().maxCoeff();
    if (!flat && (X[axis] < low - reach || X[axis] > high + reach))
    {
        return false;
    }
    const Point p = inSection(X, axis);
    bool inside = false;
    for (std::size_t k = 0; k < polygon.size(); ++k)
    {
        const Point a = polygon[k], b = polygon[(k + 1) % polygon.size()], side = b - a;
        const double share = std::clamp((p - a).dot(side) / side.squaredNorm(), 0.0, 1.0);
        if ((p - a - share * side).norm() <= reach)
        {
            return true;
        }
        if ((a.y() > p.y()) != (b.y() > p.y()) && p.x() < a.x() + side.x() * (p.y() - a.y()) / side.y())
        {
            inside = !inside;
        }
    }
    return inside;
}

double ExtrudedTank::volumeBelow(double level) const
{
    if (axis == 2)
    {
        return area() * (std::clamp(level, low, high) - low);
    }
    // The part of the polygon below, cut side by side.
    std::vector<Point> part;
    for (std::size_t k = 0; k < polygon.size(); ++k)
    {
        const Point a = polygon[k], b = polygon[(k + 1) % polygon.size()];
        if (a.y() <= level)
        {
            part.push_back(a);
        }
        if ((a.y() <= level) != (b.y() <= level))
        {
            part.emplace_back(a + (b - a) * (level - a.y()) / (b.y() - a.y()));
        }
    }
    return areaOf(part) * (high - low);
}

} // namespace slosh
