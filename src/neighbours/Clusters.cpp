// SPDX-License-Identifier: GPL-3.0-or-later
#include "neighbours/Clusters.hpp"

#include "base/CaseError.hpp"
#include "base/parallel.hpp"

#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>

namespace slosh
{

namespace
{

using Cell = Clusters::Cell;

/// What a point is sorted by: along each direction where it is in its brick, in units of 2^-31 of the edge, and among
/// those of the same place its id.
struct Key
{
    std::array<std::uint64_t, 3> x;
    int id;
    int point;

    Key() = default;
    Key(const Vec& r, const Clusters::Cell& cell, double edge, int itsId, int itsPoint)
        : x(), id(itsId), point(itsPoint)
    {
        constexpr double units = 2147483648.0;
        for (int d = 0; d < 3; ++d)
        {
            const double inBrick = std::clamp((r[d] / edge - cell[d]) * units, 0.0, units);
            x[d] = static_cast<std::uint64_t>(inBrick) << 32U | static_cast<std::uint32_t>(id);
        }
    }
};

void sortById(Key* begin, Key* end)
{
    for (Key* i = begin + 1; i < end; ++i) // a handful
    {
        const Key key = *i;
        Key* place = i;
        for (; place > begin && place[-1].id > key.id; --place)
        {
            *place = place[-1];
        }
        *place = key;
    }
}

/// Puts the keys smaller along d before `middle`: std::nth_element without branches, which processors cannot foresee
/// here.
void halve(Key* begin, Key* middle, Key* end, std::size_t d)
{
    while (end - begin > 2)
    {
        const std::uint64_t first = begin->x[d], last = end[-1].x[d], between = begin[(end - begin) / 2].x[d];
        const std::uint64_t pivot = std::max(std::min(first, last), std::min(std::max(first, last), between));
        Key* smaller = begin;
        for (Key* i = begin; i < end; ++i)
        {
            const Key key = *i;
            *i = *smaller;
            *smaller = key;
            smaller += key.x[d] < pivot ? 1 : 0;
        }
        if (smaller == middle)
        {
            return;
        }
        if (smaller == begin) // ids that are not unique
        {
            break;
        }
        (middle < smaller ? end : begin) = smaller;
    }
    std::nth_element(begin, middle, end, [d](const Key& a, const Key& b) { return a.x[d] < b.x[d]; });
}

/// Halves [begin, end) across its widest extent until each part is a cluster.
void splitIntoClusters(Key* begin, Key* end)
{
    const std::ptrdiff_t clusters = (end - begin + clusterSize - 1) / clusterSize;
    if (clusters <= 1)
    {
        sortById(begin, end);
        return;
    }
    std::array<std::uint64_t, 3> low = begin->x, high = low;
    for (const Key* key = begin; key < end; ++key)
    {
        for (std::size_t d = 0; d < 3; ++d)
        {
            low[d] = std::min(low[d], key->x[d]);
            high[d] = std::max(high[d], key->x[d]);
        }
    }
    std::size_t widest = 0;
    for (std::size_t d = 1; d < 3; ++d)
    {
        if (high[d] - low[d] > high[widest] - low[widest])
        {
            widest = d;
        }
    }
    Key* const middle = begin + clusterSize * (clusters / 2);
    halve(begin, middle, end, widest);
    splitIntoClusters(begin, middle);
    splitIntoClusters(middle, end);
}

Cell cellOf(const Vec& x, double edge)
{
    Cell cell{};
    for (int d = 0; d < 3; ++d)
    {
        constexpr double most = 1e9;
        cell[d] = static_cast<int>(std::clamp(std::floor(x[d] / edge), -most, most));
    }
    return cell;
}

} // namespace

void Clusters::build(std::span<const Vec> points, std::span<const int> ids, double brickEdge)
{
    const auto n = static_cast<std::ptrdiff_t>(points.size());
    brickEdge_ = brickEdge;
    std::vector<Cell> cellOfPoint(n);
    constexpr Cell none = {std::numeric_limits<int>::max(), 0, 0}; // beyond all cells
    parallelFor(
        n, [&](std::ptrdiff_t i) { cellOfPoint[i] = points[i].allFinite() ? cellOf(points[i], brickEdge) : none; }
    );
    // Points follow each other in bricks where they have been sorted before.
    cells_.clear();
    for (std::ptrdiff_t i = 0; i < n; ++i)
    {
        if (cellOfPoint[i] == none)
        {
            throw CaseError("the position of particle " + std::to_string(ids[i]) + " is not a number");
        }
        if (cells_.empty() || cells_.back() != cellOfPoint[i])
        {
            cells_.push_back(cellOfPoint[i]);
        }
    }
    std::sort(cells_.begin(), cells_.end());
    cells_.erase(std::unique(cells_.begin(), cells_.end()), cells_.end());

    const std::size_t bricks = cells_.size();
    std::vector<int> brickOfPoint(n), firstPoint(bricks + 1, 0);
    int brick = 0;
    for (std::ptrdiff_t i = 0; i < n; ++i)
    {
        if (cells_[brick] != cellOfPoint[i])
        {
            brick = static_cast<int>(std::lower_bound(cells_.begin(), cells_.end(), cellOfPoint[i]) - cells_.begin());
        }
        brickOfPoint[i] = brick;
        ++firstPoint[brick + 1];
    }
    firstCluster_.assign(bricks + 1, 0);
    for (std::size_t b = 0; b < bricks; ++b)
    {
        firstCluster_[b + 1] = firstCluster_[b] + (firstPoint[b + 1] + clusterSize - 1) / clusterSize;
        firstPoint[b + 1] += firstPoint[b];
    }
    std::vector<Key> keys(n);
    std::vector<int> next(firstPoint.begin(), firstPoint.end() - 1);
    for (std::ptrdiff_t i = 0; i < n; ++i)
    {
        const int b = brickOfPoint[i];
        keys[next[b]++] = {points[i], cells_[b], brickEdge, ids[i], static_cast<int>(i)};
    }
    order_.resize(n);
    firstPlace_.resize(firstCluster_.back() + 1);
    firstPlace_.back() = static_cast<int>(n);
    parallelBlocks(
        static_cast<std::ptrdiff_t>(bricks), 1,
        [&](std::ptrdiff_t b, std::ptrdiff_t)
        {
            splitIntoClusters(keys.data() + firstPoint[b], keys.data() + firstPoint[b + 1]);
            for (int i = firstPoint[b]; i < firstPoint[b + 1]; ++i)
            {
                order_[i] = keys[i].point;
            }
            for (int c = firstCluster_[b]; c < firstCluster_[b + 1]; ++c)
            {
                firstPlace_[c] = firstPoint[b] + (c - firstCluster_[b]) * clusterSize;
            }
        }
    );
}

std::size_t Clusters::bytes() const
{
    return (order_.capacity() + firstPlace_.capacity() + firstCluster_.capacity()) * sizeof(int) +
           cells_.capacity() * sizeof(Cell);
}

} // namespace slosh
