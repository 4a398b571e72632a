// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/naturalFrequencies.hpp"

#include "base/CaseError.hpp"

#include <cmath>
#include <numbers>
#include <string>

namespace slosh
{

double waveFrequency(double k, double h, double g)
{
    return std::sqrt(g * k * std::tanh(k * h));
}

double rectangularFrequency(int n, double L, double h, double g)
{
    return waveFrequency(n * std::numbers::pi / L, h, g);
}

double boxFrequency(int m, int n, double L, double B, double h, double g)
{
    return waveFrequency(std::numbers::pi * std::hypot(m / L, n / B), h, g);
}

double uprightCylinderFrequency(int m, double R, double h, double g)
{
    // the first zero > 0 of J_m'; Abramowitz & Stegun, table 9.5
    constexpr std::array<double, 3> xi{3.8317059702075123, 1.8411837813406593, 3.0542369282271403};
    if (m < 0 || m > 2)
    {
        throw CaseError("m is " + std::to_string(m) + " waves around an upright cylinder; expected 0, 1 or 2");
    }
    return waveFrequency(xi.at(static_cast<std::size_t>(m)) / R, h, g);
}

double roundTankFrequency(double lambda, double R, double g)
{
    return std::sqrt(lambda * g / R);
}

} // namespace slosh
