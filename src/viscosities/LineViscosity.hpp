// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/scalarMath.hpp"

namespace slosh
{

/// A viscosity along the line of centres in the loop's precision: one loop for all of this form,
///   Pi_ab = u (constant s_a s_b + linear (s_a + s_b))/((s_a + s_b)(q^2 + 0.01)),   s = 1/rho, q = |r_ab|/h,
/// u = v_ab . r_ab/h, of pairs that part times 1 - `closingAlone`.
template <class S>
struct LineViscosity
{
    RealOf<S> constant;     ///< [m/s kg/m^3]
    RealOf<S> linear;       ///< [m/s]
    RealOf<S> closingAlone; ///< 1: pairs that part do not count; 0: they do

    template <class Pair>
    [[gnu::always_inline]] S operator()(const Pair& pair, const S& approach) const
    {
        // One division in all.
        const S sum = pair.a.s + pair.b.s;
        const S u = subtractProduct(broadcast<S>(closingAlone), positivePart(approach), approach);
        const S strength = multiplyAdd(broadcast<S>(constant) * pair.a.s, pair.b.s, broadcast<S>(linear) * sum);
        return u * strength / (sum * (pair.q2 + RealOf<S>(0.01)));
    }
};

} // namespace slosh
