// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/blockImpact.hpp"

#include <cmath>
#include <numbers>

namespace slosh
{

namespace
{

constexpr double pi = std::numbers::pi;

/// sum_odd sign_n (1 - tanh(n pi r))/n^power, whose terms fall exponentially; what it is subtracted from is known.
double tail(double r, int power, double sign)
{
    double sum = 0, factor = 1;
    for (int n = 1; n * pi * r < 20; n += 2)
    {
        sum += factor * 2 / (std::exp(2 * n * pi * r) + 1) / std::pow(n, power);
        factor *= sign;
    }
    return sum;
}

} // namespace

double blockImpactEnergyLoss(double thicknessOverFace)
{
    constexpr double zeta3 = 1.2020569031595942; // sum_odd 1/n^3 = 7 zeta(3)/8
    return 8 / (pi * pi * pi) / thicknessOverFace * (7 * zeta3 / 8 - tail(thicknessOverFace, 3, 1));
}

double blockImpactCentreImpulse(double thicknessOverFace)
{
    constexpr double catalan = 0.9159655941772190; // 1 - 1/9 + 1/25 - ...
    return 4 / (pi * pi) * (catalan - tail(thicknessOverFace, 2, -1));
}

} // namespace slosh
