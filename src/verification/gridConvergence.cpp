// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/gridConvergence.hpp"

#include "base/CaseError.hpp"

#include <cmath>

namespace slosh
{

std::optional<double> orderOfThreeGrids(const std::array<double, 3>& dx, double change21, double change32)
{
    if (!(dx[0] > 0 && dx[0] < dx[1] && dx[1] < dx[2]))
    {
        throw CaseError("an order of three grids needs three spacings > 0, the finest first");
    }
    const double ratio = change32 / change21;
    const double coarser = std::log(dx[2] / dx[1]), finer = std::log(dx[1] / dx[0]);
    if (!std::isfinite(ratio) || !(ratio > coarser / finer))
    {
        return std::nullopt;
    }
    const auto tooLow = [&](double p) { return std::expm1(p * coarser) / -std::expm1(-p * finer) < ratio; };
    double low = 0, high = 1;
    while (tooLow(high))
    {
        low = high;
        high *= 2;
    }
    for (double p = (low + high) / 2; low < p && p < high; p = (low + high) / 2)
    {
        (tooLow(p) ? low : high) = p;
    }
    return high;
}

double extrapolated(double f1, double f2, double r, double p)
{
    return f1 + (f1 - f2) / std::expm1(p * std::log(r));
}

double gridConvergenceIndex(double change21, double r, double p, double Fs)
{
    return Fs * std::abs(change21) / std::expm1(p * std::log(r));
}

std::optional<std::size_t> errorFloor(const std::vector<double>& errors)
{
    constexpr double stillFalling = 0.9;
    for (std::size_t i = 0; i + 2 < errors.size(); ++i)
    {
        if (errors[i + 1] > stillFalling * errors[i] && errors[i + 2] > stillFalling * errors[i + 1])
        {
            return i;
        }
    }
    return std::nullopt;
}

} // namespace slosh
