// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/Shape.hpp"

#include "geometry/volumeByQuadrature.hpp"

namespace slosh
{

double Shape::volumeInside(const BoundingBox& box) const
{
    return volumeByQuadrature(bounds().intersection(box), directions_, [&](const Vec& X) { return nearestSurface(X); });
}

std::vector<std::pair<double, double>> Shape::chords(int along, const Vec& X) const
{
    constexpr int steps = 1000;
    const double low = bounds().min()[along], step = bounds().sizes()[along] / steps;
    const auto isInside = [&](double at)
    {
        Vec point = X;
        point[along] = at;
        return signedDistance(point) < 0;
    };
    // The first and the last place are outside.
    std::vector<double> ends;
    for (int k = 0; k <= steps; ++k)
    {
        double from = low + (k - 0.5) * step, to = low + (k + 0.5) * step;
        const bool enters = isInside(to);
        if (isInside(from) == enters)
        {
            continue;
        }
        for (double middle = (from + to) / 2; middle > from && middle < to; middle = (from + to) / 2)
        {
            (isInside(middle) == enters ? to : from) = middle;
        }
        ends.push_back(to);
    }
    std::vector<std::pair<double, double>> chords;
    for (std::size_t i = 0; i + 1 < ends.size(); i += 2)
    {
        chords.emplace_back(ends[i], ends[i + 1]);
    }
    return chords;
}

std::optional<BoundingBox> Shape::rectangleAt(double z) const
{
    if (directions_.size() == 3)
    {
        return std::nullopt;
    }
    const int across = directions_.front();
    BoundingBox box = bounds();
    Vec X = box.center();
    X.z() = z;
    const auto parts = chords(across, X);
    if (parts.size() != 1)
    {
        return std::nullopt;
    }
    box.min()[across] = parts.front().first;
    box.max()[across] = parts.front().second;
    return box;
}

Outline Shape::outline() const
{
    const bool isSlice = directions_.size() == 2;
    const std::array<int, 2> axes = {directions_[0], directions_[1]}; // in 3D an upright box of horizontal section
    const BoundingBox box = bounds();
    const int a = axes[0], b = axes[1];
    const Vec &low = box.min(), &high = box.max();
    const DrawnSection section{
        Polygon({{low[a], low[b]}, {high[a], low[b]}, {high[a], high[b]}, {low[a], high[b]}}), axes};
    const int along = section.along();
    return outlineOf(section, isSlice ? std::vector{box.center()[along]} : std::vector{low[along], high[along]});
}

std::optional<DrawnSection> Shape::section(double /*dx*/) const
{
    return std::nullopt;
}

bool overlap(const BoundingBox& a, const BoundingBox& b)
{
    const BoundingBox common = a.intersection(b);
    return !common.isEmpty() && common.sizes().minCoeff() > 1e-9 * a.sizes().maxCoeff();
}

} // namespace slosh
