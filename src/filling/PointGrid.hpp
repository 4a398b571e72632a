// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Vec.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <unordered_map>
#include <vector>

namespace slosh
{

/// Points of a plane in square cells, for asking which are near.
class PointGrid
{
public:
    explicit PointGrid(double cell) : cell_(cell) {}

    /// Puts in the point number `index`.
    void add(const Vec2& x, std::size_t index) { cells_[key(column(x.x()), column(x.y()))].push_back(index); }

    /// Calls f(index) for every point within one cell's width of x, and some beyond.
    template <class F>
    void forEachNear(const Vec2& x, const F& f) const
    {
        const long i = column(x.x()), j = column(x.y());
        for (long a = i - 1; a <= i + 1; ++a)
        {
            for (long b = j - 1; b <= j + 1; ++b)
            {
                if (const auto cell = cells_.find(key(a, b)); cell != cells_.end())
                {
                    std::for_each(cell->second.begin(), cell->second.end(), f);
                }
            }
        }
    }

private:
    long column(double x) const { return static_cast<long>(std::floor(x / cell_)); }
    static std::size_t key(long i, long j)
    {
        return (static_cast<std::size_t>(i) << 32) ^ (static_cast<std::size_t>(j) & 0xffffffffU);
    }

    double cell_;
    std::unordered_map<std::size_t, std::vector<std::size_t>> cells_;
};

} // namespace slosh
