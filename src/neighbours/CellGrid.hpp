// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Vec.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

namespace slosh
{

/// Points sorted into the cubic cells of a grid with a corner at the origin of coordinates, x fastest: the particles of
/// a cell, and of cells in a row along x, are contiguous in order(). Within a cell points stand in the order of `key`
/// (so that the order is a function of the points alone).
class CellGrid
{
public:
    CellGrid() = default;

    /// Sorts `points` into cells of edge `cellSize` (enlarged where the bounding box would need more than about two
    /// cells a point in memory). `key`: tie-break within a cell, unique; empty: the index itself. Throws CaseError for
    /// a point that is not finite.
    void build(std::span<const Vec> points, double cellSize, std::span<const int> key = {});

    /// Indices of the points in cell order.
    const std::vector<int>& order() const { return order_; }
    double cellSize() const { return cellSize_; }
    std::size_t bytes() const { return (start_.capacity() + order_.capacity()) * sizeof(int); }
    const std::array<int, 3>& cells() const { return cells_; }

    /// The cell coordinates of x from the first cell, not clamped.
    std::array<int, 3> cellOf(const Vec& x) const;
    /// Those of the first cell in the whole grid: a cell's are a function of place and cellSize() alone.
    std::array<int, 3> firstCell() const;

    /// Calls f(first, last) for each contiguous range of positions in order() that covers all points within `radius`
    /// (<= any) of x: ranges of cells in a row along x.
    template <class F>
    void forEachRange(const Vec& x, double radius, const F& f) const;

    /// Calls f(index) for each point in the cells within `radius` of x: a superset of those within the radius.
    template <class F>
    void forEachNear(const Vec& x, double radius, const F& f) const
    {
        forEachRange(
            x, radius,
            [&](int first, int last)
            {
                for (int k = first; k < last; ++k)
                {
                    f(order_[k]);
                }
            }
        );
    }

private:
    Vec first_ = Vec::Zero(); ///< floor(x/cellSize) of the first cell: whole numbers
    double cellSize_ = 1;
    std::array<int, 3> cells_{0, 0, 0};
    std::vector<int> start_; ///< first position in order_ of each cell, and one past the last
    std::vector<int> order_;
};

template <class F>
void CellGrid::forEachRange(const Vec& x, double radius, const F& f) const
{
    std::array<int, 3> low{}, high{};
    for (int d = 0; d < 3; ++d)
    {
        const double a = std::floor((x[d] - radius) / cellSize_) - first_[d];
        const double b = std::floor((x[d] + radius) / cellSize_) - first_[d];
        if (!(b >= 0) || !(a < cells_[d]))
        {
            return;
        }
        low[d] = a > 0 ? static_cast<int>(a) : 0;
        high[d] = b < cells_[d] ? static_cast<int>(b) : cells_[d] - 1;
    }
    for (int k = low[2]; k <= high[2]; ++k)
    {
        for (int j = low[1]; j <= high[1]; ++j)
        {
            const std::ptrdiff_t row = (static_cast<std::ptrdiff_t>(k) * cells_[1] + j) * cells_[0];
            const int first = start_[row + low[0]];
            const int last = start_[row + high[0] + 1];
            if (first < last)
            {
                f(first, last);
            }
        }
    }
}

} // namespace slosh
