// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/StretchingPatch.hpp"

#include "verification/rungeKutta.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace slosh
{

double StretchedPatch::pressure(double x, double y) const
{
    return pc * std::max(0.0, 1 - x * x / (a * a) - y * y / (b * b));
}

StretchedPatch StretchingPatch::at(double t) const
{
    // in the time A0 t, so that one step serves every A0
    const double sign = A0_ < 0 ? -1 : 1;
    const auto rate = [](double s) { return 1 / std::sqrt(std::cosh(2 * s)); };
    const double s = sign * integrateRungeKutta4(rate, std::abs(A0_) * t, 1.0 / 512);
    const double a = R_ * std::exp(-s), b = R_ * std::exp(s), A = A0_ * rate(s);
    return {a, b, A, rho_ * A * A * a * a * b * b / (a * a + b * b)};
}

double StretchingPatch::kineticEnergy() const
{
    return std::numbers::pi * rho_ * A0_ * A0_ * std::pow(R_, 4) / 4;
}

} // namespace slosh
