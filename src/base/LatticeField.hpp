// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Vec.hpp"

#include <array>
#include <cstddef>
#include <vector>

namespace slosh
{

/// A scalar at the points of a regular lattice: values[i + n_0 (j + n_1 k)] at origin + (i, j, k) * step, [m]. In the
/// empty direction of a 2D scene there is one point. Single precision: a fine lattice has many points.
struct LatticeField
{
    Vec origin = Vec::Zero();
    Vec step = Vec::Ones();
    std::array<int, 3> points{0, 0, 0}; ///< n
    std::vector<float> values;

    Vec point(std::ptrdiff_t index) const
    {
        const std::ptrdiff_t i = index % points[0], j = index / points[0] % points[1],
                             k = index / points[0] / points[1];
        return origin + Vec(static_cast<double>(i), static_cast<double>(j), static_cast<double>(k)).cwiseProduct(step);
    }
};

} // namespace slosh
