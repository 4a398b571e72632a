// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Jet.hpp"

#include <Eigen/Core>

#include <functional>
#include <limits>

namespace slosh
{

/// A rectangular tank partly filled, seen from the side.
struct RectangularTank
{
    double L = 1;      ///< length, [m]
    double h = 1;      ///< depth of the liquid, [m]
    double g = 9.81;   ///< [m/s^2]
    double rho = 1000; ///< [kg/m^3]
};

/// Prescribed motion of a tank in its plane, as formulas of time whose derivatives come along:
///
///     SwayAndRoll{.sway = [](const Jet& t) { return 0.01 * sin(4.0 * t); }}
///
/// A function that is not given is no motion. theta turns x towards y; on the project's axes it is the rotation about
/// +x in a yz scene (local x = y), and minus the rotation about +y in an xz scene.
struct SwayAndRoll
{
    using Function = std::function<Jet(const Jet& t)>;

    Function sway = {}; ///< X(t), [m]
    Function roll = {}; ///< theta(t) about the point (0, pivot), [rad]
    double pivot = 0;   ///< y0, height of the axis of roll above the mean surface, [m]
};

/// How the liquid begins at t = 0, its surface along the tank's in either case.
enum class Start
{
    withTank, ///< it moves with the tank: no velocity of the surface relative to it
    atRest    ///< it is at rest in the laboratory and the velocity of the tank jumps from 0 to X'(0), theta'(0)
};

/// Sloshing in a rectangular tank that sways and rolls, to first order in the motion: the exact solution of the linear
/// potential problem by its natural modes. In the tank's frame, x in [-L/2, L/2], y upwards from the mean surface,
/// bottom y = -h,
///
///     eta = sum_n beta_n cos k_n (x + L/2),   k_n = n pi/L,  n = 1, 3, 5 ... (even modes are not excited),
///     beta_n'' + omega_n^2 beta_n = s_n [X'' + g theta + (y0 + d_n) theta''],
///     s_n = 4 tanh(k_n h)/(L k_n),  d_n = (2/k_n) tanh(k_n h/2),  omega_n^2 = g k_n tanh(k_n h),
///     beta_n(0) = 0,  beta_n'(0) = 0 or, started at rest, s_n [X'(0) + (y0 + d_n) theta'(0)],
///
/// and the pressure, of rho (d phi/dt + g y) = -p with phi harmonic and moving with the walls,
///
///     p = -rho g y - rho { (X'' + g theta + y0 theta'') (x - sum c_n C_n E_n)
///                          + theta'' [-x y + sum c_n C_n (2 S_n - d_n E_n)] - g sum beta_n C_n E_n },
///     c_n = -4/(L k_n^2),  C_n = cos k_n (x + L/2),  E_n = cosh k_n (y + h)/cosh k_n h,
///     S_n = sinh k_n (y + h/2)/(k_n cosh(k_n h/2)).
///
/// eta is normal to the tank's own mean surface. Each mode is stepped by its exact propagator and the Duhamel integral
/// of the forcing with four Gauss points a step of 1/omega of the highest mode: an error of about 1e-9 of that mode's
/// share and far below in the others, for motions without steps and not much faster than 8 omega_1. Limits: inviscid,
/// small: |eta| << h, L and |theta| << 1; it grows without bound at resonance. The sums end after `modes` terms: at the
/// walls eta lacks up to 2 L |X'' + g theta + y0 theta''|/(pi^2 g modes) - more slowly, with its square root, after a
/// start at rest -, the pressure well below the surface nothing to speak of. Source: Faltinsen & Timokha, Sloshing
/// (2009), ch. 5.
class LinearSloshing
{
public:
    /// Throws CaseError for modes < 1.
    explicit LinearSloshing(
        const RectangularTank& tank, SwayAndRoll motion = {}, Start start = Start::withTank, int modes = 100
    );

    /// Elevation of the surface at x and t, [m]. Times may come in any order; rising ones cost least. Throws CaseError
    /// for t < 0.
    double eta(double x, double t);

    /// Pressure at (x, y) and t, [Pa]; t as above. For y > 0, under a crest, rho g (eta - y) but for the end of the
    /// sums. It is negative where the surface is below y: a gauge in the air reads 0.
    double pressure(double x, double y, double t);

    const RectangularTank& tank() const { return tank_; }

private:
    /// Carries beta and beta' over a time step.
    struct Propagator
    {
        Propagator(const Eigen::ArrayXd& omega, double step);
        double dt;
        Eigen::ArrayXd cosine, sine;
        Eigen::ArrayXXd cosines, sines; ///< from the Gauss points to the step's end, times their weights
    };

    void moveTo(double t);
    void restart();
    void step(
        const Propagator& over, const Eigen::ArrayXd& beta, const Eigen::ArrayXd& rate, Eigen::ArrayXd& newBeta,
        Eigen::ArrayXd& newRate
    ) const;
    Eigen::ArrayXd forcing(double t) const;

    RectangularTank tank_;
    SwayAndRoll motion_;
    Start start_;
    Eigen::ArrayXd k_, omega_, s_, d_, c_;
    Propagator full_;

    long stepsDone_ = 0;
    Eigen::ArrayXd beta_, rate_; ///< after stepsDone_ full steps
    double t_ = std::numeric_limits<double>::quiet_NaN();
    Eigen::ArrayXd betaNow_; ///< at t_
};

} // namespace slosh
