// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/StandingWave.hpp"

#include "verification/naturalFrequencies.hpp"

#include <cmath>
#include <numbers>

namespace slosh
{

double StandingWave::k() const
{
    return n * std::numbers::pi / L;
}

double StandingWave::omega() const
{
    return waveFrequency(k(), h, g);
}

double StandingWave::eta(double x, double t) const
{
    return a * std::cos(omega() * t) * std::cos(k() * (x + L / 2));
}

double StandingWave::pressure(double x, double y, double t) const
{
    // cosh k(y + h)/cosh k h, which does not overflow
    const double decay = std::exp(k() * y) * (1 + std::exp(-2 * k() * (y + h))) / (1 + std::exp(-2 * k() * h));
    return rho * g * (eta(x, t) * decay - y);
}

double StandingWave::frequencyRatio() const
{
    const double w0 = std::sqrt(std::tanh(k() * h));
    const double w2 = (9 * std::pow(w0, -7) - 12 * std::pow(w0, -3) - 3 * w0 - 2 * std::pow(w0, 5)) / 32;
    return 1 + k() * k() * a * a * w2 / (2 * w0);
}

} // namespace slosh
