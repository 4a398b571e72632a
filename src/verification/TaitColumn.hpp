// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace slosh
{

/// A still column of a liquid with p = B ((rho/rho0)^gamma - 1), B = rho0 c0^2/gamma, in a tank at rest; y [m] from the
/// bottom.
struct TaitColumn
{
    double h = 1;       ///< height, [m]
    double rho0 = 1000; ///< density at p = 0, [kg/m^3]
    double c0 = 10;     ///< speed of sound at p = 0, [m/s]
    double gamma = 7;   ///< > 1
    double g = 9.81;    ///< [m/s^2]

    /// dp/dy = -rho g integrated, [Pa]:
    ///     p = B ((1 + (gamma - 1) rho0 g (h - y)/(gamma B))^(gamma/(gamma - 1)) - 1).
    double pressure(double y) const;
    /// rho = rho0 (1 + p/B)^(1/gamma), [kg/m^3].
    double density(double y) const;
    /// Mass a square metre, by dp = -rho g dy: pressure(0)/g, [kg/m^2].
    double mass() const { return pressure(0) / g; }

    /// Pressure at t [s] after release with p = 0 and at rest everywhere, [Pa]: the sound it makes,
    ///     p = rho0 g (h - y) - rho0 g (F(y - c0 t) + F(y + c0 t))/2,
    /// F the triangular wave of period 4 h with F(0) = h, F(h) = 0, F(2h) = -h. At the bottom it swings between 0 and
    /// 2 rho0 g h with period 4 h/c0. To first order in g h/c0^2, without viscosity.
    double releasedPressure(double y, double t) const;

private:
    double B() const { return rho0 * c0 * c0 / gamma; }
};

} // namespace slosh
