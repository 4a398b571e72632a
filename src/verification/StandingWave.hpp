// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace slosh
{

/// A free standing wave in a rectangular tank at rest, to first order in its amplitude:
///
///     eta = a cos(omega_n t) cos k_n (x + L/2),  p = rho g (eta cosh k_n (y + h)/cosh k_n h - y),  k_n = n pi/L
///
/// x in [-L/2, L/2], y upwards from the mean surface, [m]: released from rest, a being the elevation at the left wall.
/// Inviscid; k_n a << 1. Lamb, Hydrodynamics, art. 228.
struct StandingWave
{
    double L = 1, h = 1; ///< length of the tank and depth of the liquid, [m]
    int n = 1;           ///< half waves along the tank
    double a = 0;        ///< amplitude, [m]
    double g = 9.81;     ///< [m/s^2]
    double rho = 1000;   ///< [kg/m^3]

    double k() const;
    double omega() const;
    /// Elevation above the mean surface, [m].
    double eta(double x, double t) const;
    /// Pressure, [Pa], -h <= y <= 0.
    double pressure(double x, double y, double t) const;

    /// Frequency of the wave of finite amplitude over omega():
    ///     1 + (k a)^2 w2/(2 w0),  w0^2 = tanh k h,  w2 = (9 w0^-7 - 12 w0^-3 - 3 w0 - 2 w0^5)/32,
    /// to second order in k a, for n = 1; it falls with the amplitude in deep liquid and rises where k h < 1.06.
    /// Tadjbakhsh & Keller, J. Fluid Mech. 8 (1960) 442.
    double frequencyRatio() const;
};

} // namespace slosh
