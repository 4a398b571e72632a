// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Vec.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace slosh
{

/// Points a cluster: as many as a vector of floats has lanes (base/simd.hpp).
inline constexpr int clusterSize = 8;

/// Points in clusters of neighbours, and these in bricks: blocks of cells of one global grid with a corner at the
/// origin of coordinates. Within a brick the points are halved across the widest extent, at a multiple of clusterSize,
/// until each part is a cluster: all but the last of a brick are full and compact. The order is a function of positions
/// and ids alone, and that of a brick of its own points.
class Clusters
{
public:
    /// `brickEdge`: [m]. `ids`: unique. Throws CaseError for a point that is not finite.
    void build(std::span<const Vec> points, std::span<const int> ids, double brickEdge);

    /// The points' indices in the order of clusters.
    const std::vector<int>& order() const { return order_; }
    /// The points stand in that order now.
    void pointsAreSorted() { order_ = {}; }

    /// Cluster c has the places [firstPlace(c), firstPlace(c + 1)) of the order.
    int firstPlace(std::ptrdiff_t cluster) const { return firstPlace_[cluster]; }
    int pointsIn(std::ptrdiff_t cluster) const { return firstPlace_[cluster + 1] - firstPlace_[cluster]; }
    std::ptrdiff_t clusters() const { return static_cast<std::ptrdiff_t>(firstPlace_.size()) - 1; }
    /// The point in a place of the order.
    int point(std::ptrdiff_t place) const { return order_.empty() ? static_cast<int>(place) : order_[place]; }

    /// Brick b has the clusters [firstCluster(b), firstCluster(b + 1)); bricks without points are left out, the others
    /// stand in the order of their places in the grid, x first.
    int firstCluster(std::ptrdiff_t brick) const { return firstCluster_[brick]; }
    std::ptrdiff_t bricks() const { return static_cast<std::ptrdiff_t>(firstCluster_.size()) - 1; }
    std::ptrdiff_t brickOf(int cluster) const
    {
        return std::upper_bound(firstCluster_.begin(), firstCluster_.end(), cluster) - firstCluster_.begin() - 1;
    }
    using Cell = std::array<int, 3>;
    const Cell& cell(std::ptrdiff_t brick) const { return cells_[brick]; }
    /// The bricks whose cells are [low, high] along x, y and z.
    template <class F>
    void forBricks(const Cell& low, const Cell& high, const F& f) const;

    double brickEdge() const { return brickEdge_; }
    std::size_t bytes() const;

private:
    std::vector<int> order_;
    std::vector<int> firstPlace_ = {0};
    std::vector<int> firstCluster_ = {0};
    std::vector<Cell> cells_;
    double brickEdge_ = 1;
};

template <class F>
void Clusters::forBricks(const Cell& low, const Cell& high, const F& f) const
{
    for (Cell start = low; start[0] <= high[0]; ++start[0])
    {
        for (start[1] = low[1]; start[1] <= high[1]; ++start[1])
        {
            auto brick = std::lower_bound(cells_.begin(), cells_.end(), start);
            for (;
                 brick != cells_.end() && (*brick)[0] == start[0] && (*brick)[1] == start[1] && (*brick)[2] <= high[2];
                 ++brick)
            {
                f(brick - cells_.begin());
            }
        }
    }
}

} // namespace slosh
