// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

namespace slosh
{

// Angular frequencies of free sloshing of small amplitude, [rad/s], in tanks at rest: inviscid, irrotational, without
// surface tension. Lengths in m, g in m/s^2, all > 0; mode numbers from 1 unless said.

/// omega of a wave of wave number k [1/m] on depth h: omega^2 = g k tanh(k h).
double waveFrequency(double k, double h, double g);

/// n-th mode of a rectangular tank of length L: k = n pi/L; odd n are antisymmetric. Lamb, Hydrodynamics, art. 257.
double rectangularFrequency(int n, double L, double h, double g);

/// Mode (m, n) of a box L x B: k = pi sqrt(m^2/L^2 + n^2/B^2), m, n >= 0, not both 0. Lamb, art. 257.
double boxFrequency(int m, int n, double L, double B, double h, double g);

/// Lowest mode of a circular tank with upright axis: k = xi/R with J_m'(xi) = 0, for m = 0, 1, 2 waves around the axis
/// (m = 1 is the lowest). Lamb, arts. 191, 257. Throws CaseError for another m.
double uprightCylinderFrequency(int m, double R, double h, double g);

// omega^2 R/g of tanks filled to half. McIver, J. Fluid Mech. 201 (1989) 243; a Rayleigh-Ritz computation in the tests
// confirms them.

/// Horizontal circular cylinder, waves across its axis that are odd there; the first is the lowest of all.
inline constexpr std::array<double, 2> halfFullCylinderAntisymmetric{1.355727, 4.651055};
/// The even ones.
inline constexpr std::array<double, 2> halfFullCylinderSymmetric{3.033105, 6.239198};
/// Sphere, one wave around the vertical axis (m = 1); the first is the lowest of all.
inline constexpr std::array<double, 2> halfFullSphereFirst{1.560157, 5.275546};
/// Sphere, axisymmetric (m = 0).
inline constexpr double halfFullSphereAxisymmetric = 3.745169;

/// omega = sqrt(lambda g/R) of such a lambda.
double roundTankFrequency(double lambda, double R, double g);

} // namespace slosh
