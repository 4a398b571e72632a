// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Vec.hpp"

namespace slosh
{

/// The spheroid a stretching drop has become.
struct StretchedDrop
{
    double a = 0;  ///< semi-axis along x and y, [m]
    double c = 0;  ///< semi-axis along z, [m]
    double A = 0;  ///< rate of stretching, [1/s]
    double pc = 0; ///< pressure in the centre, [Pa]

    /// v = (-A x/2, -A y/2, A z), [m/s].
    Vec velocity(const Vec& r) const { return {-A * r.x() / 2, -A * r.y() / 2, A * r.z()}; }
    /// p = pc (1 - (x^2 + y^2)/a^2 - z^2/c^2) inside, 0 outside, [Pa].
    double pressure(const Vec& r) const;
};

/// A sphere of inviscid incompressible liquid without gravity, released with v = (-A0 x/2, -A0 y/2, A0 z): a free
/// surface that stays a spheroid, the patch of StretchingPatch in three dimensions.
///
/// Derivation. a' = -A a/2 and c' = A c carry the surface. Dv/Dt = -grad p/rho reads
///
///     -A'/2 + A^2/4 = 2 pc/(rho a^2)  (along x and y),    A' + A^2 = 2 pc/(rho c^2)  (along z),
///
/// and eliminating A' or pc leaves
///
///     pc = (3/4) rho A^2 a^2 c^2/(a^2 + 2 c^2),    A' = A^2 (a^2 - 4 c^2)/(2 (a^2 + 2 c^2)).
///
/// Volume, a^2 c = R^3, and kinetic energy, A^2 (a^2 + 2 c^2) = 3 A0^2 R^2, are kept, so that with c = R e^s,
/// a = R e^(-s/2) all of it is s' = A0 sqrt(3/(e^-s + 2 e^2s)), which is integrated here with a relative error below
/// 1e-12. A particle that began at (x0, y0, z0) is at (x0 a/R, y0 a/R, z0 c/R).
class StretchingDrop
{
public:
    /// A0 [1/s]; its sign says whether the drop lengthens or flattens. R > 0 [m], rho > 0 [kg/m^3].
    StretchingDrop(double A0, double R, double rho) : A0_(A0), R_(R), rho_(rho) {}

    /// At time t >= 0, [s].
    StretchedDrop at(double t) const;

    /// (pi/5) rho R^5 A0^2 at all times, [J].
    double kineticEnergy() const;

private:
    double A0_, R_, rho_;
};

} // namespace slosh
