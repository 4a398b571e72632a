// SPDX-License-Identifier: GPL-3.0-or-later
#include "neighbours/CellGrid.hpp"

#include "base/CaseError.hpp"
#include "base/boundingBox.hpp"
#include "base/parallel.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

namespace slosh
{

namespace
{

void requireFinite(std::span<const Vec> points, std::span<const int> key)
{
    const auto n = static_cast<std::ptrdiff_t>(points.size());
    const std::ptrdiff_t first = parallelReduce(
        n, n,
        [&](std::ptrdiff_t begin, std::ptrdiff_t end)
        {
            while (begin < end && points[begin].allFinite())
            {
                ++begin;
            }
            return begin < end ? begin : n;
        },
        [](std::ptrdiff_t a, std::ptrdiff_t b) { return std::min(a, b); }
    );
    if (first < n)
    {
        const int particle = key.empty() ? static_cast<int>(first) : key[first];
        throw CaseError("the position of particle " + std::to_string(particle) + " is not a number");
    }
}

} // namespace

void CellGrid::build(std::span<const Vec> points, double cellSize, std::span<const int> key)
{
    requireFinite(points, key);
    const BoundingBox box = boundingBox(points);
    order_.resize(points.size());
    if (points.empty())
    {
        cells_ = {0, 0, 0};
        start_.assign(1, 0);
        return;
    }

    // A few points far away must not cost memory: cells grow until there are at most some per point.
    const double most = 64.0 + 4.0 * static_cast<double>(points.size());
    const auto cellsAlong = [&](int d) { return std::floor(box.max()[d] / cellSize_) - first_[d] + 1; };
    for (cellSize_ = cellSize;; cellSize_ *= 1.25)
    {
        first_ = (box.min() / cellSize_).array().floor();
        if (cellsAlong(0) * cellsAlong(1) * cellsAlong(2) <= most)
        {
            break;
        }
    }
    for (int d = 0; d < 3; ++d)
    {
        cells_[d] = static_cast<int>(cellsAlong(d));
    }

    std::vector<int> cell(points.size());
    start_.assign(static_cast<std::size_t>(cells_[0]) * cells_[1] * cells_[2] + 1, 0);
    parallelFor(
        static_cast<std::ptrdiff_t>(points.size()),
        [&](std::ptrdiff_t i)
        {
            const auto c = cellOf(points[i]);
            cell[i] = (c[2] * cells_[1] + c[1]) * cells_[0] + c[0];
        }
    );
    for (const int c : cell)
    {
        ++start_[c + 1];
    }
    std::partial_sum(start_.begin(), start_.end(), start_.begin());
    std::vector<int> next(start_.begin(), start_.end() - 1);
    for (std::size_t i = 0; i < points.size(); ++i)
    {
        order_[next[cell[i]]++] = static_cast<int>(i);
    }
    if (!key.empty())
    {
        parallelFor(
            static_cast<std::ptrdiff_t>(start_.size()) - 1,
            [&](std::ptrdiff_t c)
            {
                std::sort(
                    order_.begin() + start_[c], order_.begin() + start_[c + 1],
                    [&](int a, int b) { return key[a] < key[b]; }
                );
            }
        );
    }
}

std::array<int, 3> CellGrid::cellOf(const Vec& x) const
{
    std::array<int, 3> c{};
    for (int d = 0; d < 3; ++d)
    {
        c[d] = static_cast<int>(std::floor(x[d] / cellSize_) - first_[d]);
    }
    return c;
}

std::array<int, 3> CellGrid::firstCell() const
{
    return {static_cast<int>(first_[0]), static_cast<int>(first_[1]), static_cast<int>(first_[2])};
}

} // namespace slosh
