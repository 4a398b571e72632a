// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace slosh
{

// Liquid at rest in a tank that accelerates or turns steadily: level eta [m] above the bottom, and the pressure under
// it. h is the depth at rest [m], g in m/s^2, rho in kg/m^3. The constructors throw CaseError where the bottom would
// fall dry: the formulas, which keep the volume, hold while all of it is wet and no lid is touched.

/// A tank of length L with the constant acceleration (ax, ay) [m/s^2], ay > -g upwards, x in [-L/2, L/2] from its
/// middle:
///     eta = h - ax x/(g + ay),   p = rho (g + ay) (eta - y).
class TiltedLevel
{
public:
    TiltedLevel(double L, double h, double ax, double ay, double g);
    double eta(double x) const { return h_ - ax_ * x / g_; }
    /// [Pa] at height y above the bottom.
    double pressure(double x, double y, double rho) const { return rho * g_ * (eta(x) - y); }

private:
    double h_, ax_, g_; ///< g_ is g + ay
};

/// A tank that turns steadily about its vertical middle axis with w [rad/s]: eta = h + w^2 (r^2 - <r^2>)/(2 g), with
/// <r^2>, the mean of r^2 over the bottom, R^2/2 in a circular tank of radius R, L^2/12 in a slot of length L (r = x)
/// and (a^2 + b^2)/12 in a box a x b; p = rho g (eta - y).
class RotatingLevel
{
public:
    static RotatingLevel cylinder(double R, double h, double w, double g);
    static RotatingLevel slot(double L, double h, double w, double g);
    static RotatingLevel box(double a, double b, double h, double w, double g);

    /// At distance r [m] from the axis.
    double eta(double r) const { return h_ + curvature_ * (r * r - meanSquare_); }
    /// [Pa] at distance r and height y above the bottom.
    double pressure(double r, double y, double rho) const { return rho * g_ * (eta(r) - y); }

private:
    RotatingLevel(double meanSquare, double h, double w, double g);
    double meanSquare_, h_, g_, curvature_;
};

} // namespace slosh
