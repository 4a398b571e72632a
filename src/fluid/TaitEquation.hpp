// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/scalarMath.hpp"

#include <cmath>

namespace slosh
{

/// x^(1/7) for 1/2 <= x <= 2, to two units in the last place: three steps of Halley's method for y^7 = x, from 1.
template <class S>
S seventhRoot(const S& x)
{
    S y = (x * 8.0 + 6.0) / (x * 6.0 + 8.0);
    for (int step = 0; step < 2; ++step)
    {
        const S y3 = y * y * y, y7 = y3 * y3 * y;
        y = y * (y7 * 6.0 + x * 8.0) / (y7 * 8.0 + x * 6.0);
    }
    return y;
}

/// Tait's equation of state, Cao et al. 2014: p = B ((rho/rho0)^gamma - 1), B = rho0 c0^2/gamma.
struct TaitEquation
{
    double rho0 = 1000; ///< density at p = 0, [kg/m^3]
    double c0 = 0;      ///< speed of sound at rho0, [m/s]
    double gamma = 7;

    double B() const { return rho0 * c0 * c0 / gamma; } ///< [Pa]
    double p(double rho) const                          ///< [Pa]
    {
        const double ratio = rho / rho0;
        if (gamma == 7)
        {
            const double r3 = ratio * ratio * ratio;
            return B() * (r3 * r3 * ratio - 1);
        }
        return B() * (std::pow(ratio, gamma) - 1);
    }
    /// [kg/m^3], for p > -B; S: double or a vector of them.
    template <class S>
    S rho(const S& p) const
    {
        const S x = p * (1 / B()) + 1.0;
        const bool isNearOne = whereLess(x, S(0.5)) == 0 && whereLess(S(2.0), x) == 0;
        return rho0 * (gamma == 7 && isNearOne
                           ? seventhRoot(x)
                           : ofEach(x, [this](double ratio) { return std::pow(ratio, 1 / gamma); }));
    }
    /// The water hammer of Joukowsky: of liquid that is stopped at the speed u [m/s], [Pa].
    double waterHammer(double u) const { return rho0 * c0 * u; }

    /// Energy of compression, int_rho0^rho p/rho^2 drho with x = rho/rho0:
    ///   B/rho0 ((x^(gamma-1) - 1)/(gamma - 1) + 1/x - 1), [J/kg]; gamma = 1: ln x in place of the quotient.
    double energy(double rho) const
    {
        const double x = rho / rho0;
        const double power = gamma == 1 ? std::log(x) : (std::pow(x, gamma - 1) - 1) / (gamma - 1);
        return B() / rho0 * (power + 1 / x - 1);
    }

    /// Pressure at depth d below a free surface under the acceleration g, from dp/dd = rho(p) g:
    ///   p = B ((1 + (gamma - 1) rho0 g d/(gamma B))^(gamma/(gamma - 1)) - 1);  gamma = 1: B (e^(rho0 g d/B) - 1).
    double hydrostatic(double g, double depth) const
    {
        const double x = rho0 * g * depth / B();
        return gamma == 1 ? B() * std::expm1(x)
                          : B() * (std::pow(1 + (gamma - 1) / gamma * x, gamma / (gamma - 1)) - 1);
    }
    /// The depth at which hydrostatic() is p, [m].
    double depth(double g, double p) const
    {
        const double x =
            gamma == 1 ? std::log1p(p / B()) : gamma / (gamma - 1) * (std::pow(1 + p / B(), (gamma - 1) / gamma) - 1);
        return x * B() / (rho0 * g);
    }
};

} // namespace slosh
