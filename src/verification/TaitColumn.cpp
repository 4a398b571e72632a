// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/TaitColumn.hpp"

#include <cmath>

namespace slosh
{

double TaitColumn::pressure(double y) const
{
    const double n = gamma / (gamma - 1);
    // (1 + z)^n - 1 without cancellation: z is small, g h/c0^2 being about 0.01
    return B() * std::expm1(n * std::log1p(rho0 * g * (h - y) / (n * B())));
}

double TaitColumn::density(double y) const
{
    return rho0 * std::pow(1 + pressure(y) / B(), 1 / gamma);
}

double TaitColumn::releasedPressure(double y, double t) const
{
    const auto F = [this](double z) { return h - std::abs(std::remainder(z, 4 * h)); };
    return rho0 * g * (h - y - (F(y - c0 * t) + F(y + c0 * t)) / 2);
}

} // namespace slosh
