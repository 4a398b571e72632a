// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/NonlinearSloshing.hpp"

#include "verification/rungeKutta.hpp"

#include "base/CaseError.hpp"

#include <cmath>
#include <string>
#include <utility>

namespace slosh
{

namespace
{

/// Points on which products of order M, and what they are made of, are free of aliasing in the first N modes.
Eigen::Index pointsFor(const SpectralResolution& resolution)
{
    if (resolution.modes < 1 || resolution.order < 1 || !(resolution.step > 0))
    {
        throw CaseError(
            "nonlinear sloshing: " + std::to_string(resolution.modes) + " modes of order " +
            std::to_string(resolution.order) + ", time step " + std::to_string(resolution.step) +
            "; expected at least 1 mode, order >= 1 and a time step > 0"
        );
    }
    return (resolution.order + 1) * resolution.modes / 2 + 1;
}

/// sum_{i + j <= order} W_i W_j, where column m of `sums` is W_1 + ... + W_m.
Eigen::ArrayXd squareTo(int order, const Eigen::ArrayXXd& W, const Eigen::ArrayXXd& sums)
{
    Eigen::ArrayXd square = Eigen::ArrayXd::Zero(W.rows());
    for (int i = 1; i < order; ++i)
    {
        square += W.col(i - 1) * sums.col(order - i);
    }
    return square;
}

} // namespace

NonlinearSloshing::NonlinearSloshing(
    const RectangularTank& tank, SwayAndRoll::Function sway, Start start, const SpectralResolution& resolution
)
    : tank_(tank), sway_(std::move(sway)), M_(resolution.order),
      expansion_(CosineModes(tank.L, pointsFor(resolution)), tank.h, M_),
      k_(expansion_.modes().waveNumbers().head(resolution.modes + 1)), x_(Eigen::ArrayXd::Zero(k_.size())),
      dt_(resolution.step / std::sqrt(tank.g * k_(resolution.modes)))
{
    for (Eigen::Index n = 1; n < k_.size(); n += 2)
    {
        x_(n) = -4 / (tank.L * k_(n) * k_(n));
    }
    filter_ = (-36 * (k_ / k_(resolution.modes)).pow(36)).exp();
    State state = State::Zero(k_.size(), 2);
    if (start == Start::atRest && sway_)
    {
        state.col(1) = -sway_(Jet::time(0)).d * x_;
    }
    states_.push_back(state);
    rates_.push_back(rate(0, state));
}

NonlinearSloshing::NonlinearSloshing(const StandingWave& wave, const SpectralResolution& resolution)
    : NonlinearSloshing({.L = wave.L, .h = wave.h, .g = wave.g, .rho = wave.rho}, {}, Start::withTank, resolution)
{
    if (wave.n < 0 || wave.n >= k_.size())
    {
        throw CaseError(
            "a standing wave of " + std::to_string(wave.n) + " half wavelengths is requested with " +
            std::to_string(resolution.modes) + " modes"
        );
    }
    states_[0](wave.n, 0) = wave.a;
    rates_[0] = rate(0, states_[0]);
}

double NonlinearSloshing::swayAcceleration(double t) const
{
    return sway_ ? sway_(Jet::time(t)).dd : 0;
}

NonlinearSloshing::State NonlinearSloshing::rate(double t, const State& state) const
{
    const CosineModes& modes = expansion_.modes();
    const Eigen::ArrayXXd value = modes.values(state), slope = modes.slopes(state);
    const Eigen::ArrayXXd W = expansion_(value.col(0), value.col(1)).W;
    Eigen::ArrayXXd sums = Eigen::ArrayXXd::Zero(W.rows(), M_ + 1);
    for (int m = 1; m <= M_; ++m)
    {
        sums.col(m) = sums.col(m - 1) + W.col(m - 1);
    }
    State onGrid = State::Zero(W.rows(), 2);
    onGrid.col(0) = sums.col(M_);
    if (M_ > 1)
    {
        const Eigen::ArrayXd steepness = slope.col(0).square();
        onGrid.col(0) += steepness * sums.col(M_ - 2) - slope.col(0) * slope.col(1);
        onGrid.col(1) = (squareTo(M_, W, sums) + steepness * squareTo(M_ - 2, W, sums) - slope.col(1).square()) / 2;
    }
    State rate = modes.amplitudes(onGrid, state.rows());
    rate.col(1) -= tank_.g * state.col(0) + swayAcceleration(t) * x_;
    return rate;
}

void NonlinearSloshing::advance()
{
    const double begin = static_cast<double>(states_.size() - 1) * dt_;
    State state = rungeKutta4Step(
        [this](double t, const State& y) { return rate(t, y); }, begin, states_.back(), rates_.back(), dt_
    );
    state.colwise() *= filter_;
    if (!(expansion_.modes().slopes(state.leftCols(1)).abs().maxCoeff() <= 1))
    {
        throw CaseError(
            "the surface of nonlinear sloshing is steeper than 45 degrees at t = " + std::to_string(begin + dt_) +
            " s: the wave breaks, or " + std::to_string(k_.size() - 1) + " modes of order " + std::to_string(M_) +
            " do not resolve it"
        );
    }
    states_.push_back(state);
    rates_.push_back(rate(begin + dt_, state));
}

NonlinearSloshing::State NonlinearSloshing::at(double t)
{
    if (!(t >= 0))
    {
        throw CaseError("nonlinear sloshing begins at t = 0; requested at " + std::to_string(t) + " s");
    }
    const auto n = static_cast<std::size_t>(t / dt_);
    while (states_.size() < n + 2)
    {
        advance();
    }
    const double u = t / dt_ - static_cast<double>(n), v = 1 - u;
    return v * v * (1 + 2 * u) * states_[n] + u * u * (1 + 2 * v) * states_[n + 1] +
           u * v * dt_ * (v * rates_[n] - u * rates_[n + 1]);
}

double NonlinearSloshing::eta(double x, double t)
{
    return (at(t).col(0) * (k_ * (x + tank_.L / 2)).cos()).sum();
}

double NonlinearSloshing::energy(double t)
{
    const State state = at(t);
    const Eigen::ArrayXd share = state.col(1) * rate(t, state).col(0) + tank_.g * state.col(0).square();
    return tank_.rho * tank_.L / 4 * (share.sum() + share(0));
}

double NonlinearSloshing::pressure(double x, double y, double t)
{
    const State state = at(t);
    const CosineModes& modes = expansion_.modes();
    const Eigen::ArrayXXd value = modes.values(state), change = modes.values(rate(t, state));
    const double highest = value.col(0).abs().maxCoeff();
    if (!(y <= -highest))
    {
        throw CaseError(
            "pressure of nonlinear sloshing requested at y = " + std::to_string(y) + "; at t = " + std::to_string(t) +
            " s it is defined below " + std::to_string(-highest)
        );
    }
    // phi_t is harmonic too, and psi_t - W eta_t on the surface
    const HarmonicExpansion::Terms potential = expansion_(value.col(0), value.col(1));
    const Eigen::ArrayXd phi = potential.phi;
    const Eigen::ArrayXd phi_t =
        expansion_(value.col(0), change.col(1) - potential.W.rowwise().sum() * change.col(0)).phi;

    // cosh k(y + h)/cosh k h and sinh k(y + h)/cosh k h, which do not overflow
    const Eigen::ArrayXd& k = modes.waveNumbers();
    const Eigen::ArrayXd decay = (k * y).exp() / (1 + (-2 * k * tank_.h).exp());
    const Eigen::ArrayXd below = (-2 * k * (y + tank_.h)).exp();
    const Eigen::ArrayXd E = decay * (1 + below), S = decay * (1 - below);
    const Eigen::ArrayXd phase = k * (x + tank_.L / 2);
    const double u = -(phi * k * E * phase.sin()).sum(), v = (phi * k * S * phase.cos()).sum();
    const double phiRate = (phi_t * E * phase.cos()).sum();
    return -tank_.rho * (phiRate + (u * u + v * v) / 2 + tank_.g * y + swayAcceleration(t) * x);
}

} // namespace slosh
