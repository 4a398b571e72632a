// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/scalarMath.hpp"

#include <numbers>
#include <string_view>

namespace slosh
{

/// Quintic spline: f(q) = (3-q)+^5 - 6 (2-q)+^5 + 15 (1-q)+^5. Cao et al. 2014, Table 1 (Morris 1996).
struct QuinticSpline
{
    static constexpr std::string_view name = "quinticSpline";
    static constexpr std::string_view sentence = "Quintic spline, support 3h (Morris 1996)";
    static constexpr double supportRatio = 3;
    static double alpha(int dim) { return (dim == 2 ? 7.0 / 478.0 : 1.0 / 120.0) / std::numbers::pi; }

    template <class S>
    static S f(S q2)
    {
        const S q = squareRoot(q2);
        const S outer = multiplyAdd(S(-6), fifth(positivePart(2 - q)), fifth(positivePart(3 - q)));
        return multiplyAdd(S(15), fifth(positivePart(1 - q)), outer);
    }

    /// (1/q) df/dq = -120 + 120 q^2 - 50 q^3 (q < 1: expanded, because the powers cancel there),
    /// -5 ((3-q)^4 - 6 (2-q)+^4) / q.
    template <class S>
    static S dfByQ(S q2)
    {
        const S q = squareRoot(q2);
        const S outer = -5 * multiplyAdd(S(-6), fourth(positivePart(2 - q)), fourth(positivePart(3 - q))) / q;
        return select(q < 1, multiplyAdd(q2, multiplyAdd(S(-50), q, S(120)), S(-120)), outer);
    }

private:
    template <class S>
    static S fourth(S a)
    {
        const S a2 = a * a;
        return a2 * a2;
    }

    template <class S>
    static S fifth(S a)
    {
        return fourth(a) * a;
    }
};

} // namespace slosh
