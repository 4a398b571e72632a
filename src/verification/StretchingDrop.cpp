// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/StretchingDrop.hpp"

#include "verification/rungeKutta.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace slosh
{

double StretchedDrop::pressure(const Vec& r) const
{
    return pc * std::max(0.0, 1 - r.head<2>().squaredNorm() / (a * a) - r.z() * r.z() / (c * c));
}

StretchedDrop StretchingDrop::at(double t) const
{
    // in the time A0 t, so that one step serves every A0
    const double sign = A0_ < 0 ? -1 : 1;
    const auto rate = [sign](double s) { return sign * std::sqrt(3 / (std::exp(-s) + 2 * std::exp(2 * s))); };
    const double s = integrateRungeKutta4(rate, std::abs(A0_) * t, 1.0 / 512);
    const double a = R_ * std::exp(-s / 2), c = R_ * std::exp(s), A = std::abs(A0_) * rate(s);
    return {a, c, A, 0.75 * rho_ * A * A * a * a * c * c / (a * a + 2 * c * c)};
}

double StretchingDrop::kineticEnergy() const
{
    return std::numbers::pi / 5 * rho_ * A0_ * A0_ * std::pow(R_, 5);
}

} // namespace slosh
