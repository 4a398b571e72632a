// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/scalarMath.hpp"

#include <numbers>
#include <string_view>

namespace slosh
{

/// Cubic spline: f(q) = 4 - 6 q^2 + 3 q^3 (q < 1), (2 - q)^3 (1 <= q < 2). Cao et al. 2014, Table 1 (Monaghan &
/// Lattanzio 1985). f = (2-q)+^3 - 4 (1-q)+^3.
struct CubicSpline
{
    static constexpr std::string_view name = "cubicSpline";
    static constexpr std::string_view sentence = "Cubic spline, support 2h (Monaghan & Lattanzio 1985)";
    static constexpr double supportRatio = 2;
    static double alpha(int dim) { return (dim == 2 ? 5.0 / 14.0 : 0.25) / std::numbers::pi; }

    template <class S>
    static S f(S q2)
    {
        const S q = squareRoot(q2);
        const S a = positivePart(2 - q);
        const S b = positivePart(1 - q);
        return multiplyAdd(S(-4), b * b * b, a * a * a);
    }

    /// (1/q) df/dq = 9 q - 12 (q < 1), -3 (2 - q)^2 / q.
    template <class S>
    static S dfByQ(S q2)
    {
        const S q = squareRoot(q2);
        const S a = positivePart(2 - q);
        return select(q < 1, multiplyAdd(S(9), q, S(-12)), -3 * a * a / q);
    }
};

} // namespace slosh
