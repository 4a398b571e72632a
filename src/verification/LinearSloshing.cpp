// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/LinearSloshing.hpp"

#include "base/CaseError.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

namespace slosh
{

namespace
{

/// Gauss-Legendre points and weights on [0, 1], exact to degree 7.
constexpr std::array<double, 4> gaussPoint{
    0.06943184420297371, 0.33000947820757187, 0.66999052179242813, 0.93056815579702629};
constexpr std::array<double, 4> gaussWeight{
    0.17392742256872693, 0.32607257743127307, 0.32607257743127307, 0.17392742256872693};

Eigen::ArrayXd oddWaveNumbers(double L, int modes)
{
    if (modes < 1)
    {
        throw CaseError("linear sloshing: " + std::to_string(modes) + " modes; expected at least 1");
    }
    return (2 * Eigen::ArrayXd::LinSpaced(modes, 0, modes - 1) + 1) * std::numbers::pi / L;
}

Jet value(const SwayAndRoll::Function& function, double t)
{
    return function ? function(Jet::time(t)) : Jet(0);
}

} // namespace

LinearSloshing::Propagator::Propagator(const Eigen::ArrayXd& omega, double step)
    : dt(step), cosine((omega * step).cos()), sine((omega * step).sin()), cosines(omega.size(), gaussPoint.size()),
      sines(omega.size(), gaussPoint.size())
{
    for (std::size_t i = 0; i < gaussPoint.size(); ++i)
    {
        const Eigen::ArrayXd phase = omega * ((1 - gaussPoint[i]) * step);
        cosines.col(static_cast<Eigen::Index>(i)) = step * gaussWeight[i] * phase.cos();
        sines.col(static_cast<Eigen::Index>(i)) = step * gaussWeight[i] * phase.sin();
    }
}

LinearSloshing::LinearSloshing(const RectangularTank& tank, SwayAndRoll motion, Start start, int modes)
    : tank_(tank), motion_(std::move(motion)), start_(start), k_(oddWaveNumbers(tank.L, modes)),
      omega_((tank.g * k_ * (k_ * tank.h).tanh()).sqrt()), s_(4 / tank.L * (k_ * tank.h).tanh() / k_),
      d_(2 / k_ * (k_ * tank.h / 2).tanh()), c_(-4 / tank.L / k_.square()),
      full_(omega_, 1 / std::max(omega_(modes - 1), 8 * omega_(0)))
{
    restart();
}

void LinearSloshing::restart()
{
    stepsDone_ = 0;
    beta_ = Eigen::ArrayXd::Zero(k_.size());
    rate_ = beta_;
    if (start_ == Start::atRest)
    {
        // the integral of the right side over the jump, in which theta itself does not change
        rate_ = s_ * (value(motion_.sway, 0).d + (motion_.pivot + d_) * value(motion_.roll, 0).d);
    }
}

Eigen::ArrayXd LinearSloshing::forcing(double t) const
{
    const Jet X = value(motion_.sway, t), theta = value(motion_.roll, t);
    return s_ * (X.dd + tank_.g * theta.f + (motion_.pivot + d_) * theta.dd);
}

void LinearSloshing::step(
    const Propagator& over, const Eigen::ArrayXd& beta, const Eigen::ArrayXd& rate, Eigen::ArrayXd& newBeta,
    Eigen::ArrayXd& newRate
) const
{
    const double begin = static_cast<double>(stepsDone_) * full_.dt;
    Eigen::ArrayXd beta1 = over.cosine * beta + over.sine / omega_ * rate;
    Eigen::ArrayXd rate1 = over.cosine * rate - over.sine * omega_ * beta;
    for (std::size_t i = 0; i < gaussPoint.size(); ++i)
    {
        const Eigen::ArrayXd f = forcing(begin + gaussPoint[i] * over.dt);
        beta1 += over.sines.col(static_cast<Eigen::Index>(i)) / omega_ * f;
        rate1 += over.cosines.col(static_cast<Eigen::Index>(i)) * f;
    }
    newBeta = std::move(beta1);
    newRate = std::move(rate1);
}

void LinearSloshing::moveTo(double t)
{
    if (t == t_)
    {
        return;
    }
    if (!(t >= 0))
    {
        throw CaseError("linear sloshing begins at t = 0; requested at " + std::to_string(t) + " s");
    }
    // whole steps from 0 and one shorter one, so that what is found at t does not depend on what was asked before
    const auto steps = static_cast<long>(std::floor(t / full_.dt));
    if (steps < stepsDone_)
    {
        restart();
    }
    for (; stepsDone_ < steps; ++stepsDone_)
    {
        step(full_, beta_, rate_, beta_, rate_);
    }
    Eigen::ArrayXd rateNow;
    step(Propagator(omega_, t - static_cast<double>(steps) * full_.dt), beta_, rate_, betaNow_, rateNow);
    t_ = t;
}

double LinearSloshing::eta(double x, double t)
{
    moveTo(t);
    return (betaNow_ * (k_ * (x + tank_.L / 2)).cos()).sum();
}

double LinearSloshing::pressure(double x, double y, double t)
{
    moveTo(t);
    const double h = tank_.h, g = tank_.g;
    const double level = std::min(y, 0.0); // the modes do not reach above it
    const Jet X = value(motion_.sway, t), theta = value(motion_.roll, t);
    const Eigen::ArrayXd C = (k_ * (x + tank_.L / 2)).cos();
    // quotients of hyperbolic functions, in a form that does not overflow
    const Eigen::ArrayXd E = (k_ * level).exp() * (1 + (-2 * k_ * (level + h)).exp()) / (1 + (-2 * k_ * h).exp());
    const Eigen::ArrayXd S = ((k_ * level).exp() - (-k_ * (level + h)).exp()) / (k_ * (1 + (-k_ * h).exp()));
    const double carried = (X.dd + g * theta.f + motion_.pivot * theta.dd) * (x - (c_ * C * E).sum());
    const double turned = theta.dd * (-x * level + (c_ * C * (2 * S - d_ * E)).sum());
    return -tank_.rho * (g * y + carried + turned - g * (betaNow_ * C * E).sum());
}

} // namespace slosh
