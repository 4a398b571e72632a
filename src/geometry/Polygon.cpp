// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/Polygon.hpp"

#include "base/pointText.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace slosh
{

namespace
{

double cross(const Vec2& a, const Vec2& b)
{
    return a.x() * b.y() - a.y() * b.x();
}

double signedArea(const std::vector<Vec2>& corners)
{
    double twice = 0;
    for (std::size_t i = 0; i < corners.size(); ++i)
    {
        // From the first corner: no digits lost far from the origin.
        twice += cross(corners[i] - corners.front(), corners[(i + 1) % corners.size()] - corners.front());
    }
    return twice / 2;
}

/// The part with sign (x_axis - bound) <= 0, by Sutherland & Hodgman: of a polygon that is not convex the pieces may be
/// joined by sides there and back, which have no area.
std::vector<Vec2> cut(const std::vector<Vec2>& corners, int axis, double bound, double sign)
{
    std::vector<Vec2> part;
    for (std::size_t i = 0; i < corners.size(); ++i)
    {
        const Vec2 &a = corners[i], &b = corners[(i + 1) % corners.size()];
        const double da = sign * (a[axis] - bound), db = sign * (b[axis] - bound);
        if (da <= 0)
        {
            part.push_back(a);
        }
        if ((da < 0 && db > 0) || (da > 0 && db < 0))
        {
            part.emplace_back(a + da / (da - db) * (b - a));
        }
    }
    return part;
}

double distanceToSegment(const Vec2& x, const Vec2& a, const Vec2& b)
{
    const double t = std::clamp((x - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
    return (x - a - t * (b - a)).norm();
}

bool meet(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d, double slack)
{
    const auto apart = [](const Vec2& p, const Vec2& q, const Vec2& r, const Vec2& s)
    { return cross(q - p, r - p) * cross(q - p, s - p) < 0; };
    const double nearest = std::min(
        {distanceToSegment(a, c, d), distanceToSegment(b, c, d), distanceToSegment(c, a, b), distanceToSegment(d, a, b)}
    );
    return (apart(a, b, c, d) && apart(c, d, a, b)) || nearest < slack;
}

} // namespace

std::string Polygon::fault(const std::vector<Vec2>& corners)
{
    const std::size_t n = corners.size();
    if (n < 3)
    {
        return "has " + std::to_string(n) + (n == 1 ? " corner" : " corners") + "; expected at least 3";
    }
    Vec2 low = corners.front(), high = low;
    for (const Vec2& x : corners)
    {
        low = low.cwiseMin(x);
        high = high.cwiseMax(x);
    }
    const double slack = 1e-9 * (high - low).norm();
    const auto at = [&](std::size_t i) -> const Vec2& { return corners[i % n]; };
    for (std::size_t i = 0; i < n; ++i)
    {
        for (std::size_t j = i + 1; j < n; ++j)
        {
            if ((at(i) - at(j)).norm() <= slack)
            {
                return "has the corner " + text(at(i)) + " twice";
            }
        }
    }
    const auto offLine = [](const Vec2& x, const Vec2& a, const Vec2& b)
    { return std::abs(cross(b - a, x - a)) / (b - a).norm(); };
    if (std::all_of(corners.begin(), corners.end(), [&](const Vec2& x) { return offLine(x, at(0), at(1)) <= slack; }))
    {
        return "has no area: its corners lie on one line";
    }
    for (std::size_t i = 0; i < n; ++i)
    {
        if (offLine(at(i + 1), at(i), at(i + 2)) <= slack)
        {
            return "has the corner " + text(at(i + 1)) + " on the straight line through its neighbours; omit it";
        }
    }
    for (std::size_t i = 0; i < n; ++i)
    {
        for (std::size_t j = i + 2; j < n - (i == 0 ? 1 : 0); ++j)
        {
            if (meet(at(i), at(i + 1), at(j), at(j + 1), slack))
            {
                return "intersects itself: the side " + text(at(i)) + " to " + text(at(i + 1)) + " meets the side " +
                       text(at(j)) + " to " + text(at(j + 1)) + "";
            }
        }
    }
    return "";
}

Polygon::Polygon(std::vector<Vec2> corners) : corners_(std::move(corners)), low_(corners_.front()), high_(low_)
{
    if (signedArea(corners_) < 0)
    {
        std::reverse(corners_.begin(), corners_.end());
    }
    for (const Vec2& x : corners_)
    {
        low_ = low_.cwiseMin(x);
        high_ = high_.cwiseMax(x);
    }
}

const Vec2& Polygon::corner(std::ptrdiff_t i) const
{
    const auto n = static_cast<std::ptrdiff_t>(corners_.size());
    return corners_[(i % n + n) % n];
}

Vec2 Polygon::outward(std::ptrdiff_t side) const
{
    const Vec2 along = (corner(side + 1) - corner(side)).normalized();
    return {along.y(), -along.x()};
}

bool Polygon::isRectangle() const
{
    return corners_.size() == 4 &&
           std::all_of(
               corners_.begin(), corners_.end(),
               [&](const Vec2& x)
               { return (x.x() == low_.x() || x.x() == high_.x()) && (x.y() == low_.y() || x.y() == high_.y()); }
           );
}

double Polygon::areaInside(const Vec2& low, const Vec2& high) const
{
    std::vector<Vec2> part = corners_;
    for (int axis = 0; axis < 2; ++axis)
    {
        part = cut(cut(part, axis, low[axis], -1), axis, high[axis], 1);
    }
    return part.empty() || (high - low).minCoeff() <= 0 ? 0 : signedArea(part);
}

std::vector<std::pair<double, double>> Polygon::chords(int along, double at) const
{
    const int other = 1 - along;
    std::vector<double> ends;
    for (std::size_t i = 0; i < corners_.size(); ++i)
    {
        const Vec2 &a = corners_[i], &b = corners_[(i + 1) % corners_.size()];
        if ((a[other] > at) != (b[other] > at))
        {
            ends.push_back(a[along] + (at - a[other]) / (b[other] - a[other]) * (b[along] - a[along]));
        }
    }
    std::sort(ends.begin(), ends.end());
    std::vector<std::pair<double, double>> chords;
    for (std::size_t i = 0; i + 1 < ends.size(); i += 2)
    {
        chords.emplace_back(ends[i], ends[i + 1]);
    }
    return chords;
}

bool Polygon::contains(const Vec2& x) const
{
    // How often a ray to the right crosses sides.
    bool inside = false;
    const Vec2* a = &corners_.back();
    for (const Vec2& b : corners_)
    {
        if ((a->y() > x.y()) != (b.y() > x.y()) && (cross(b - *a, x - *a) > 0) == (b.y() > a->y()))
        {
            inside = !inside;
        }
        a = &b;
    }
    return inside;
}

NearestSide Polygon::nearest(const Vec2& x) const
{
    NearestSide nearest;
    double least = std::numeric_limits<double>::infinity();
    const auto n = static_cast<std::ptrdiff_t>(corners_.size());
    for (std::ptrdiff_t i = 0; i < n; ++i)
    {
        const Vec2 &a = corner(i), &b = corner(i + 1);
        const Vec2 side = b - a;
        const double t = (x - a).dot(side) / side.squaredNorm();
        const bool isCorner = t < 0 || t > 1;
        const Vec2 away = x - (t < 0 ? a : t > 1 ? b : Vec2(a + t * side));
        const double distance = away.norm();
        if (!(distance < least))
        {
            continue;
        }
        least = distance;
        const Vec2 outward = this->outward(i);
        if (!isCorner || distance == 0)
        {
            nearest.distance = outward.dot(x - a);
            nearest.normal = outward;
            continue;
        }
        // Nearest to a corner that is reflex are points inside, to one that is not, points outside.
        const std::ptrdiff_t k = t < 0 ? i : i + 1;
        const double sign = cross(corner(k) - corner(k - 1), corner(k + 1) - corner(k)) > 0 ? 1 : -1;
        nearest.distance = sign * distance;
        nearest.normal = sign / distance * away;
    }
    return nearest;
}

} // namespace slosh
