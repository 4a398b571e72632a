// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernels/Kernel.hpp"
#include "neighbours/CellGrid.hpp"

#include <cstddef>
#include <span>

namespace slosh
{

/// The scalar sibling of physics/walk.hpp, in double precision, around any point: calls f(b, r - points[b]) for the
/// points b of `grid`, which was built of them, within the support of the kernel around r.
template <class F>
void forNeighbours(const CellGrid& grid, std::span<const Vec> points, const Kernel& kernel, const Vec& r, const F& f)
{
    const double R = kernel.supportRadius();
    grid.forEachNear(
        r, R,
        [&](std::ptrdiff_t b)
        {
            if (const Vec r_ab = r - points[b]; r_ab.squaredNorm() < R * R)
            {
                f(b, r_ab);
            }
        }
    );
}

} // namespace slosh
