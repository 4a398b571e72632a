// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/ViscousStandingWave.hpp"

#include "verification/naturalFrequencies.hpp"

#include <cmath>
#include <numbers>

namespace slosh
{

namespace
{

using Complex = std::complex<double>;

/// Decays of vorticity in the sum: their residues fall as q^-8 once q is above k.
int vorticityCount(double k, double h)
{
    return 50 + static_cast<int>(20 * k * h);
}

} // namespace

ViscousStandingWave::ViscousStandingWave(double k, double h, double g, double nu) : k_(k), h_(h), g_(g), nu_(nu)
{
    const auto edge = [&](int n) { return -nu_ * (k_ * k_ + std::pow(n * std::numbers::pi / h_, 2)); };
    for (int n = 1; n <= vorticityCount(k, h); ++n)
    {
        vorticity_.push_back(realRoot(edge(n), edge(n + 1)));
    }
    findGravityRoots();
}

Complex ViscousStandingWave::dispersion(Complex s) const
{
    const Complex m = std::sqrt(k_ * k_ + s / nu_);
    const Complex mCoth = std::abs(m * h_) < 1e-4 ? (1.0 + m * m * h_ * h_ / 3.0) / h_ : m / std::tanh(m * h_);
    const Complex sigma = s + 2 * nu_ * k_ * k_;
    const double T = std::tanh(k_ * h_);
    return sigma * sigma + g_ * k_ * T - 4 * nu_ * nu_ * k_ * k_ * k_ * T * mCoth;
}

Complex ViscousStandingWave::slope(Complex s) const
{
    const Complex m = std::sqrt(k_ * k_ + s / nu_);
    const Complex t = std::tanh(m * h_);
    // d(m coth mh)/dm /(2 nu m) = (coth mh - m h (coth^2 mh - 1))/(2 nu m), h/(3 nu) at m = 0
    const Complex bend =
        std::abs(m * h_) < 1e-4 ? Complex(h_ / (3 * nu_)) : (1.0 / t - m * h_ * (1.0 / (t * t) - 1.0)) / (2 * nu_ * m);
    return 2.0 * (s + 2 * nu_ * k_ * k_) - 4 * nu_ * nu_ * k_ * k_ * k_ * std::tanh(k_ * h_) * bend;
}

Complex ViscousStandingWave::newton(Complex s) const
{
    for (int iteration = 0; iteration < 50; ++iteration)
    {
        const Complex change = dispersion(s) / slope(s);
        s -= change;
        if (std::abs(change) <= 1e-15 * std::abs(s))
        {
            break;
        }
    }
    return s;
}

double ViscousStandingWave::realRoot(double from, double to) const
{
    // D is negative (minus infinity, between decays of vorticity) at `from` and positive at `to`
    for (double middle = (from + to) / 2; middle != from && middle != to; middle = (from + to) / 2)
    {
        (dispersion(middle).real() < 0 ? from : to) = middle;
    }
    return (from + to) / 2;
}

void ViscousStandingWave::findGravityRoots()
{
    // On the real axis D is positive at s = 0 and at its first pole; strong viscosity makes it negative in between.
    const double pole = -nu_ * (k_ * k_ + std::pow(std::numbers::pi / h_, 2));
    double left = pole, right = 0;
    for (int iteration = 0; iteration < 200; ++iteration)
    {
        const double third = (right - left) / 3;
        const bool lowerOnTheLeft = dispersion(left + third).real() < dispersion(right - third).real();
        (lowerOnTheLeft ? right : left) += lowerOnTheLeft ? -third : third;
    }
    const double lowest = (left + right) / 2;
    if (dispersion(lowest).real() < 0)
    {
        gravity_ = {realRoot(lowest, 0), realRoot(lowest, pole)};
        return;
    }
    // followed from weak viscosity, where the root is known
    constexpr int stages = 64;
    Complex s(0, waveFrequency(k_, h_, g_));
    for (int stage = 1; stage <= stages; ++stage)
    {
        ViscousStandingWave weaker = *this;
        weaker.nu_ = nu_ * stage / stages;
        s = weaker.newton(s - 2 * k_ * k_ * nu_ / stages);
    }
    gravity_ = {s, std::conj(s)};
}

template <class F>
double ViscousStandingWave::sumOverRoots(const F& share) const
{
    Complex sum = share(gravity_.first) + share(gravity_.second);
    for (const double s : vorticity_)
    {
        sum += share(Complex(s));
    }
    return sum.real();
}

double ViscousStandingWave::eta(double t) const
{
    return -g_ * k_ * std::tanh(k_ * h_) * sumOverRoots([&](Complex s) { return std::exp(s * t) / (s * slope(s)); });
}

double ViscousStandingWave::etaSetInMotion(double t) const
{
    return sumOverRoots([&](Complex s) { return std::exp(s * t) / slope(s); });
}

double decayRateBetweenWalls(double k, double h, double L, double B, double g, double nu)
{
    const double sinh2kh = std::sinh(2 * k * h);
    const double layers = k / sinh2kh + (1 - 2 * k * h / sinh2kh) / L + 1 / B;
    return 2 * nu * k * k + std::sqrt(nu * waveFrequency(k, h, g) / 2) * layers;
}

} // namespace slosh
