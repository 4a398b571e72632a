// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/scalarMath.hpp"

#include <cmath>
#include <numbers>
#include <string_view>

namespace slosh
{

/// Gaussian that is led smoothly to zero: f(q) = e^(-q^2) (1 - q^2/9)^3, q < 3. Cut off by a jump in its slope, as the
/// improved Gaussian is, a kernel has a Fourier transform of some 1e-5 at the wave number 2 pi/dx of a lattice, and
/// sums over particles feel their lattice: it resists shear, breaks up by itself and damps waves of less than a
/// spacing (docs/decisions/0020-a-kernel-that-does-not-feel-the-lattice.md). Here it is below 1e-6 for h >= 1.4 dx,
/// nearly as wide as the improved Gaussian with 1.23 dx; 55 neighbours in 2D instead of 43.
struct TaperedGaussian
{
    static constexpr std::string_view name = "taperedGaussian";
    static constexpr std::string_view sentence =
        "Gaussian tapered smoothly to 0 at 3h: sums are independent of the lattice for h >= 1.4 dx";
    static constexpr double supportRatio = 3;

    /// 1 over the integral of f: in 2D pi J_3 with J_n = int_0^9 e^-s (1 - s/9)^n ds = 1 - (n/9) J_(n-1), J_0 = 1 -
    /// e^-9; in 3D 4 pi (M_1 - M_2/3 + M_3/27 - M_4/729), M_n = int_0^3 q^2n e^(-q^2) dq = (2n - 1)/2 M_(n-1) -
    /// 3^(2n-1) e^-9/2.
    static double alpha(int dim)
    {
        const double eToMinus9 = std::exp(-9.0);
        if (dim == 2)
        {
            double J = 1 - eToMinus9;
            for (int n = 1; n <= 3; ++n)
            {
                J = 1 - n * J / 9;
            }
            return 1 / (std::numbers::pi * J);
        }
        const double factors[] = {0, 1, -1.0 / 3, 1.0 / 27, -1.0 / 729};
        double M = std::sqrt(std::numbers::pi) / 2 * std::erf(3.0), sum = 0;
        for (int n = 1; n <= 4; ++n)
        {
            M = (2 * n - 1) / 2.0 * M - std::pow(3.0, 2 * n - 1) * eToMinus9 / 2;
            sum += factors[n] * M;
        }
        return 1 / (4 * std::numbers::pi * sum);
    }

    template <class S>
    static S f(S q2)
    {
        const S inside = atMost(9, q2);
        const S left = 9 - inside; // exactly 0 outside the support
        return RealOf<S>(1.0 / 729) * expOfMinus(inside) * (left * left * left);
    }

    /// (1/q) df/dq = -2 e^(-q^2) (1 - q^2/9)^2 (4/3 - q^2/9).
    template <class S>
    static S dfByQ(S q2)
    {
        const S inside = atMost(9, q2);
        const S left = 9 - inside;
        return RealOf<S>(-2.0 / 729) * expOfMinus(inside) * (left * left * (left + 3));
    }
};

} // namespace slosh
