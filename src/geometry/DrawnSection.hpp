// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/Polygon.hpp"

#include <array>

namespace slosh
{

/// A polygon in the plane of two axes, drawn out along the third.
struct DrawnSection
{
    Polygon polygon;
    std::array<int, 2> axes; ///< of its plane: {1, 2} yz

    int along() const { return 3 - axes[0] - axes[1]; }
    Vec2 inSection(const Vec& X) const { return {X[axes[0]], X[axes[1]]}; }
    Vec point(const Vec2& x, double at) const ///< `at`: along the third axis, [m]
    {
        Vec X;
        X[axes[0]] = x[0];
        X[axes[1]] = x[1];
        X[along()] = at;
        return X;
    }
};

} // namespace slosh
