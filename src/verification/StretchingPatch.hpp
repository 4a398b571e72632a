// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace slosh
{

/// The ellipse a stretching patch has become.
struct StretchedPatch
{
    double a = 0;  ///< semi-axis along x, [m]
    double b = 0;  ///< semi-axis along y, [m]
    double A = 0;  ///< rate of stretching, [1/s]
    double pc = 0; ///< pressure in the centre, [Pa]

    /// v = (-A x, A y), [m/s].
    Eigen::Vector2d velocity(double x, double y) const { return {-A * x, A * y}; }
    /// p = pc (1 - x^2/a^2 - y^2/b^2) inside, 0 outside, [Pa].
    double pressure(double x, double y) const;
};

/// A circular patch of inviscid incompressible liquid without gravity, released with v = (-A0 x, A0 y): a free surface
/// that stays an ellipse.
///
///     a' = -A a,  b' = A b,  A' = A^2 (a^2 - b^2)/(a^2 + b^2),  pc = rho A^2 a^2 b^2/(a^2 + b^2)
///
/// follow from Dv/Dt = -grad p/rho with p quadratic. Area, a b = R^2, and kinetic energy, A^2 (a^2 + b^2) = 2 A0^2 R^2,
/// are kept, so that with b = R e^s, a = R e^-s all of it is s' = A0/sqrt(cosh 2s), which is integrated here with a
/// relative error below 1e-12. A particle that began at (x0, y0) is at (x0 a/R, y0 b/R).
/// Source: Monaghan, J. Comput. Phys. 110 (1994) 399; Cao, Ming & Zhang 2014, Eq. 7 (its p0 lacks a square).
class StretchingPatch
{
public:
    /// A0 [1/s], R > 0 [m], rho > 0 [kg/m^3].
    StretchingPatch(double A0, double R, double rho) : A0_(A0), R_(R), rho_(rho) {}

    /// At time t >= 0, [s].
    StretchedPatch at(double t) const;

    /// pi rho R^2 A0^2 R^2/4 a metre of width, at all times, [J/m].
    double kineticEnergy() const;

private:
    double A0_, R_, rho_;
};

} // namespace slosh
