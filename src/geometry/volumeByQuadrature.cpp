// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/volumeByQuadrature.hpp"

#include <algorithm>
#include <cmath>

namespace slosh
{

namespace
{

struct Quadrature
{
    const std::vector<int>& directions;
    const std::function<NearestSurface(const Vec&)>& nearest;

    /// Of a cell, as a share of it.
    double share(const Vec& centre, const Vec& edges, int halvings) const
    {
        double diagonal2 = 0;
        for (const int d : directions)
        {
            diagonal2 += edges[d] * edges[d];
        }
        const NearestSurface surface = nearest(centre);
        if (std::abs(surface.distance) >= std::sqrt(diagonal2) / 2)
        {
            return surface.distance < 0 ? 1 : 0;
        }
        double extent = 0; // of the cell, along the normal
        for (const int d : directions)
        {
            extent += std::abs(surface.normal[d]) * edges[d];
        }
        const double linear = extent > 0 ? std::clamp(0.5 - surface.distance / extent, 0.0, 1.0) : 0.5;
        if (halvings == 0)
        {
            return linear;
        }
        const int parts = 1 << directions.size();
        double sum = 0;
        for (int part = 0; part < parts; ++part)
        {
            Vec at = centre, half = edges;
            for (std::size_t k = 0; k < directions.size(); ++k)
            {
                const int d = directions[k];
                half[d] = edges[d] / 2;
                at[d] += ((part >> k) % 2 == 0 ? -0.5 : 0.5) * half[d];
            }
            sum += share(at, half, halvings - 1);
        }
        // What the surface's curvature adds falls with the square of the cells' size.
        return halvings == 1 ? std::clamp((4 * sum / parts - linear) / 3, 0.0, 1.0) : sum / parts;
    }
};

} // namespace

double volumeByQuadrature(
    const BoundingBox& box, const std::vector<int>& directions, const std::function<NearestSurface(const Vec&)>& nearest
)
{
    if (box.isEmpty())
    {
        return 0;
    }
    const Quadrature quadrature{directions, nearest};
    return box.volume() * quadrature.share(box.center(), box.sizes(), directions.size() == 2 ? 9 : 6);
}

double volumeOfBoth(const Shape& a, const Shape& b, const BoundingBox& box)
{
    if (b.fillsBounds())
    {
        return a.volumeInside(box.intersection(b.bounds()));
    }
    const auto holds = [](const Shape& outer, const BoundingBox& inner)
    { return outer.volumeInside(inner) >= inner.volume() * (1 - 1e-9); };
    if (a.fillsBounds() || holds(a, b.bounds()))
    {
        return b.volumeInside(box.intersection(a.bounds()));
    }
    return volumeByQuadrature(
        box.intersection(a.bounds()).intersection(b.bounds()), a.directions(),
        [&](const Vec& X)
        {
            const NearestSurface first = a.nearestSurface(X), second = b.nearestSurface(X);
            return first.distance > second.distance ? first : second;
        }
    );
}

} // namespace slosh
