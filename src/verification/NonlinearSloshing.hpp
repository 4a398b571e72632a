// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "verification/HarmonicExpansion.hpp"
#include "verification/LinearSloshing.hpp"
#include "verification/StandingWave.hpp"

#include <vector>

namespace slosh
{

/// How finely nonlinear sloshing is computed.
struct SpectralResolution
{
    int modes = 64;    ///< N, cosine modes of the surface
    int order = 5;     ///< M, in powers of the amplitude; 1 is linear theory
    double step = 0.5; ///< of time, times 1/sqrt(g k_N); Runge-Kutta's limit is 2.8
};

/// Sloshing in a rectangular tank that sways, or a standing wave in one at rest: inviscid, irrotational, of finite
/// amplitude, by a high-order spectral method. In the tank's frame, x in [-L/2, L/2], y upwards from the mean surface,
/// bottom y = -h, the surface y = eta(x, t) and the potential psi = phi(x, eta, t) of the velocity relative to the tank
/// obey
///
///     eta_t = W (1 + eta_x^2) - psi_x eta_x,
///     psi_t = -g eta - X'' x + W^2 (1 + eta_x^2)/2 - psi_x^2/2,        W = dphi/dy on the surface,
///
/// with W of HarmonicExpansion and every product taken to the order M in eta and psi together. Both are sums of
/// cos k_n (x + L/2), k_n = n pi/L, n = 0 ... N; all products are computed without aliasing, so that this is Galerkin's
/// projection of a Hamiltonian system: its energy is kept but for the time step. Time goes by the classical Runge-Kutta
/// method in equal steps, cubic Hermite polynomials between them; after each, mode n is multiplied with
/// exp(-36 (n/N)^36), without which the highest modes grow on steep waves (Hou & Li, J. Comput. Phys. 226 (2007) 379).
/// It damps the highest quarter of the modes.
///
/// Begins with a level surface, moving with the tank or at rest in the laboratory (psi = -X'(0) x), or with that of a
/// standing wave, at rest. Since eta_x = -X''/g at the walls, the amplitudes of a swaying tank fall as 1/n^2: the error
/// as N^-3/2 (root mean square over the surface), as 1/N at the walls; those of a standing wave fall exponentially.
///
/// Sources: Dommermuth & Yue, J. Fluid Mech. 184 (1987) 267; the order of the products: West et al., J. Geophys. Res.
/// 92 (1987) 11803; the Hamiltonian: Zakharov 1968, Craig & Sulem, J. Comput. Phys. 108 (1993) 73.
class NonlinearSloshing
{
public:
    /// A tank that sways as X(t) = sway, [m]; none is a tank at rest. Throws CaseError for modes or order < 1 and a
    /// step that is not > 0.
    explicit NonlinearSloshing(
        const RectangularTank& tank, SwayAndRoll::Function sway = {}, Start start = Start::withTank,
        const SpectralResolution& resolution = {}
    );

    /// Released from eta = a cos k_n (x + L/2). Throws CaseError as above and where n > modes.
    explicit NonlinearSloshing(const StandingWave& wave, const SpectralResolution& resolution = {});

    // Times may come in any order: all steps are kept. Each throws CaseError for t < 0, and for t beyond the one where
    // the surface is steeper than 45 degrees, the steepest standing wave (Penney & Price 1952): it breaks, or its
    // modes no longer describe it.

    /// Elevation of the surface, [m].
    double eta(double x, double t);

    /// Pressure, [Pa], of Bernoulli's equation with phi and phi_t from HarmonicExpansion. y <= -max|eta|, where no term
    /// of its sums is large: throws CaseError above.
    double pressure(double x, double y, double t);

    /// Kinetic energy relative to the tank and potential one above that of the level surface, per metre of breadth,
    /// [J/m]: rho/2 integral (psi eta_t + g eta^2) dx. It changes by -rho X'' integral x eta_t dx a second.
    double energy(double t);

    /// The step of time, [s].
    double timeStep() const { return dt_; }

private:
    using State = Eigen::ArrayX2d; ///< amplitudes of eta and psi, or their rates

    State at(double t);
    void advance();
    State rate(double t, const State& state) const;
    double swayAcceleration(double t) const;

    RectangularTank tank_;
    SwayAndRoll::Function sway_;
    int M_;
    HarmonicExpansion expansion_;
    Eigen::ArrayXd k_; ///< of the modes of the state
    Eigen::ArrayXd x_; ///< amplitudes of x
    Eigen::ArrayXd filter_;
    double dt_;
    std::vector<State> states_, rates_; ///< at 0, dt, 2 dt ...
};

} // namespace slosh
