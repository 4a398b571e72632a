// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/scalarMath.hpp"

#include <numbers>
#include <string_view>

namespace slosh
{

/// Wendland C2: f(q) = (2 - q)^4 (1 + 2 q), q < 2. Cao et al. 2014, Table 1 (Wendland 1995).
struct WendlandC2
{
    static constexpr std::string_view name = "wendlandC2";
    static constexpr std::string_view sentence = "Wendland C2 polynomial, support 2h (Wendland 1995)";
    static constexpr double supportRatio = 2;
    static double alpha(int dim) { return (dim == 2 ? 7.0 / 64.0 : 21.0 / 256.0) / std::numbers::pi; }

    template <class S>
    static S f(S q2)
    {
        const S q = squareRoot(q2);
        const S a = positivePart(2 - q);
        const S a2 = a * a;
        return a2 * a2 * multiplyAdd(S(2), q, S(1));
    }

    /// (1/q) df/dq = -10 (2 - q)^3.
    template <class S>
    static S dfByQ(S q2)
    {
        const S a = positivePart(2 - squareRoot(q2));
        return -10 * (a * a * a);
    }
};

} // namespace slosh
