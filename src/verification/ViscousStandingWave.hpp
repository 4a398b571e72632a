// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <complex>
#include <utility>
#include <vector>

namespace slosh
{

/// A standing wave of small amplitude on a viscous liquid over a free-slip bottom, between free-slip walls: linearised
/// Navier-Stokes equations, exact. Modes e^(s t) satisfy
///
///     (s + 2 nu k^2)^2 + g k tanh k h = 4 nu^2 k^3 m tanh(k h)/tanh(m h),   m^2 = k^2 + s/nu:
///
/// one pair of waves, s = +-i omega - 2 nu k^2 + ... for nu -> 0, or two real decays where viscosity is strong, and the
/// decays of vorticity, m = i q with one q in each (n pi, (n + 1) pi)/h, n = 1, 2 ... Released from rest with amplitude
/// a,
///
///     eta/a = -g k tanh(k h) sum_s e^(s t)/(s D'(s)),   D = left side - right side of the equation above,
///
/// the residues of the Laplace transform eta^ = (a/s) (1 - g k tanh(k h)/D); set in motion from its flat state by a
/// potential flow whose surface rises with u0,
///
///     eta/u0 = sum_s e^(s t)/D'(s),   eta^ = u0/D.
///
/// Lamb, Hydrodynamics, art. 349, for infinite depth; Prosperetti, Phys. Fluids 19 (1976) 195, for the starts. Not for
/// nu where the two real decays meet (to one part in 10^6), nor nu = 0 (StandingWave).
class ViscousStandingWave
{
public:
    /// Wave number k [1/m], depth h [m], g [m/s^2], kinematic viscosity nu [m^2/s], all > 0.
    ViscousStandingWave(double k, double h, double g, double nu);

    /// The waves: s = -decay +- i omega, the one with omega > 0 first; or two real decays, the slower first, [1/s].
    std::pair<std::complex<double>, std::complex<double>> gravityRoots() const { return gravity_; }
    /// omega, 0 where the liquid creeps back without a wave, [rad/s].
    double frequency() const { return gravity_.first.imag(); }
    /// Rate at which the amplitude falls, [1/s].
    double decayRate() const { return -gravity_.first.real(); }

    /// Elevation over its value at t = 0, released from rest, t >= 0 [s].
    double eta(double t) const;
    /// Elevation over the surface's velocity at t = 0, set in motion from its flat state, t >= 0 [s]; [s].
    double etaSetInMotion(double t) const;

    /// D(s), [1/s^2]: 0 at each root.
    std::complex<double> dispersion(std::complex<double> s) const;
    /// The decays of vorticity used in eta, all s < 0, the slowest first, [1/s].
    const std::vector<double>& vorticityRoots() const { return vorticity_; }

private:
    std::complex<double> slope(std::complex<double> s) const; ///< D'(s)
    std::complex<double> newton(std::complex<double> s) const;
    double realRoot(double below, double above) const;
    void findGravityRoots();
    template <class F>
    double sumOverRoots(const F& share) const; ///< of the shares, functions of s; real

    double k_, h_, g_, nu_;
    std::pair<std::complex<double>, std::complex<double>> gravity_;
    std::vector<double> vorticity_;
};

/// Rate of decay of the first-order standing wave k on depth h, frequency omega, between no-slip walls a length L apart
/// and side walls a breadth B apart (infinity: plane flow), for thin boundary layers, [1/s]:
///     2 nu k^2 + sqrt(nu omega/2) [k/sinh 2kh + (1 - 2kh/sinh 2kh)/L + 1/B],
/// half the dissipation over the energy, with Stokes layers at the bottom, the two ends and the two sides. The surface
/// is clean. Keulegan, J. Fluid Mech. 6 (1959) 33.
double decayRateBetweenWalls(double k, double h, double L, double B, double g, double nu);

} // namespace slosh
