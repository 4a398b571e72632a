// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Vec.hpp"
#include "base/parallel.hpp"

#include <span>

namespace slosh
{

/// The smallest box that holds all points, [m]; empty for none.
inline BoundingBox boundingBox(std::span<const Vec> points)
{
    return parallelReduce(
        static_cast<std::ptrdiff_t>(points.size()), BoundingBox(),
        [&](std::ptrdiff_t begin, std::ptrdiff_t end)
        {
            BoundingBox box;
            for (std::ptrdiff_t i = begin; i < end; ++i)
            {
                box.extend(points[i]);
            }
            return box;
        },
        [](const BoundingBox& a, const BoundingBox& b) { return a.merged(b); }
    );
}

} // namespace slosh
