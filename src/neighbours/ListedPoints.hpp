// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/parallel.hpp"
#include "base/simd.hpp"
#include "neighbours/Clusters.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <span>
#include <vector>

namespace slosh
{

/// The box of some points, and the widest of their skins; single precision, from an origin.
template <int dim>
struct ReachBox
{
    std::array<float, dim> low, high;
    float skin = 0;

    ReachBox()
    {
        low.fill(std::numeric_limits<float>::max());
        high.fill(std::numeric_limits<float>::lowest());
    }
    void extend(const ReachBox& other)
    {
        for (std::size_t d = 0; d < dim; ++d)
        {
            low[d] = std::min(low[d], other.low[d]);
            high[d] = std::max(high[d], other.high[d]);
        }
        skin = std::max(skin, other.skin);
    }
    /// Whether points of both can be nearer than `reach` and their skins.
    bool reaches(const ReachBox& other, float reach) const
    {
        float gap2 = 0;
        for (std::size_t d = 0; d < dim; ++d)
        {
            const float gap = std::max({0.0F, low[d] - other.high[d], other.low[d] - high[d]});
            gap2 += gap * gap;
        }
        const float nearer = reach + skin + other.skin;
        return gap2 < nearer * nearer;
    }
};

/// Points with their skins, cluster by cluster, in single precision from an origin: for the search alone.
template <int dim>
class ListedPoints
{
public:
    using S = Simd<float>;
    static_assert(lanesOf<S> == clusterSize);

    struct Cluster
    {
        std::array<std::array<float, clusterSize>, dim> x; ///< far away where there is no point
        std::array<float, clusterSize> skin;
    };

    ListedPoints(
        const Clusters& clusters, std::span<const Vec> points, std::span<const double> skins,
        std::span<const int> directions, const Vec& origin
    )
        : clusters_(clusters.clusters()), boxes_(clusters.clusters()), bricks_(clusters.bricks())
    {
        parallelBlocks(
            clusters.bricks(), 1,
            [&](std::ptrdiff_t b, std::ptrdiff_t)
            {
                for (int c = clusters.firstCluster(b); c < clusters.firstCluster(b + 1); ++c)
                {
                    Cluster& cluster = clusters_[c];
                    const int n = clusters.pointsIn(c);
                    for (int k = 0; k < clusterSize; ++k)
                    {
                        ReachBox<dim> point;
                        const int i = k < n ? clusters.point(clusters.firstPlace(c) + k) : -1;
                        cluster.skin[k] = point.skin = k < n ? static_cast<float>(skins[i]) : 0;
                        for (std::size_t d = 0; d < dim; ++d)
                        {
                            const int along = directions[d];
                            cluster.x[d][k] = k < n ? static_cast<float>(points[i][along] - origin[along]) : 1e15F;
                            point.low[d] = point.high[d] = cluster.x[d][k];
                        }
                        if (k < n)
                        {
                            boxes_[c].extend(point);
                        }
                    }
                    bricks_[b].extend(boxes_[c]);
                }
            }
        );
    }

    const Cluster& cluster(std::ptrdiff_t c) const { return clusters_[c]; }
    const ReachBox<dim>& box(std::ptrdiff_t c) const { return boxes_[c]; }
    const ReachBox<dim>& brickBox(std::ptrdiff_t brick) const { return bricks_[brick]; }
    /// The largest coordinate.
    float extent() const
    {
        float most = 0;
        for (const ReachBox<dim>& box : bricks_)
        {
            for (std::size_t d = 0; d < dim; ++d)
            {
                most = std::max({most, -box.low[d], box.high[d]});
            }
        }
        return most;
    }

private:
    std::vector<Cluster> clusters_;
    std::vector<ReachBox<dim>> boxes_, bricks_;
};

} // namespace slosh
