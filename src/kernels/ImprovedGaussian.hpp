// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/scalarMath.hpp"

#include <cmath>
#include <numbers>
#include <string_view>

namespace slosh
{

/// Improved (truncated, shifted) Gaussian: f(q) = e^(-q^2) - e^(-9), q <= 3. Cao et al. 2014, Table 1; alpha in 3D is
/// the exact one (the paper's is 0.17 % low), so that the integral of W over its support is 1 in both.
struct ImprovedGaussian
{
    static constexpr std::string_view name = "improvedGaussian";
    static constexpr std::string_view sentence = "Gaussian truncated at 3h and shifted to 0 there (Cao et al. 2014)";
    static constexpr double supportRatio = 3;
    static double alpha(int dim)
    {
        const double pi = std::numbers::pi;
        return dim == 2 ? 1 / (pi * (1 - 10 * eToMinus9))
                        : 1 / (std::pow(pi, 1.5) * std::erf(3.0) - 42 * pi * eToMinus9);
    }

    template <class S>
    static S f(S q2)
    {
        // The rounding of e^-9 must not leave a weight outside the support.
        return select(q2 < 9, positivePart(expOfMinus(q2) - RealOf<S>(eToMinus9)), S(0));
    }

    /// (1/q) df/dq = -2 e^(-q^2).
    template <class S>
    static S dfByQ(S q2)
    {
        return select(q2 < 9, -2 * expOfMinus(q2), S(0));
    }

private:
    static constexpr double eToMinus9 = 1.2340980408667956e-4;
};

} // namespace slosh
