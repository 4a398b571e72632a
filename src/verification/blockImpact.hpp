// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace slosh
{

// A block of incompressible liquid, H thick, hits a rigid wall with its whole face of length L at once, speed U normal
// to it. The pressure impulse P [Pa s] is harmonic, rho U = -dP/dn at the wall, 0 on the three free sides; along the
// wall
//     P = (4 rho U L/pi^2) sum_odd tanh(n pi H/L) sin(n pi x/L)/n^2,   0 <= x <= L.
// Plane flow without gravity; a weakly compressible run approaches it after the sound has left. The series are summed
// to rounding. Source: Cooker & Peregrine, J. Fluid Mech. 297 (1995) 193, for the method.

/// Energy lost over kinetic energy before, as a function of H/L > 0:
///     Delta E/E0 = (8/pi^3) (L/H) sum_odd tanh(n pi H/L)/n^3.
/// The same number is the impulse on the whole wall over the momentum before, rho U L H.
double blockImpactEnergyLoss(double thicknessOverFace);

/// P in the middle of the wall over rho U L: (4/pi^2) sum_odd (-1)^((n-1)/2) tanh(n pi H/L)/n^2.
double blockImpactCentreImpulse(double thicknessOverFace);

} // namespace slosh
