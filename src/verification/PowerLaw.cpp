// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/PowerLaw.hpp"

#include "base/CaseError.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace slosh
{

double PowerLaw::operator()(double x) const
{
    return C * std::pow(x, p);
}

double PowerLaw::inverse(double y) const
{
    return p == 0 ? std::numeric_limits<double>::quiet_NaN() : std::pow(y / C, 1 / p);
}

PowerLaw fitPowerLaw(const std::vector<double>& x, const std::vector<double>& y)
{
    const auto usable = [](double value) { return value > 0 && std::isfinite(value); };
    if (x.size() < 2 || x.size() != y.size() || !std::all_of(x.begin(), x.end(), usable) ||
        !std::all_of(y.begin(), y.end(), usable))
    {
        throw CaseError(
            "a power law needs two or more pairs of values > 0; there are " + std::to_string(x.size()) + " and " +
            std::to_string(y.size()) + " values"
        );
    }
    const auto n = static_cast<double>(x.size());
    double meanX = 0, meanY = 0;
    for (std::size_t i = 0; i < x.size(); ++i)
    {
        meanX += std::log(x[i]) / n;
        meanY += std::log(y[i]) / n;
    }
    double xx = 0, xy = 0;
    for (std::size_t i = 0; i < x.size(); ++i)
    {
        const double d = std::log(x[i]) - meanX;
        xx += d * d;
        xy += d * (std::log(y[i]) - meanY);
    }
    if (!(xx > 0))
    {
        throw CaseError("a power law needs different values; all are " + std::to_string(x.front()));
    }
    const double p = xy / xx;
    double residuals = 0;
    for (std::size_t i = 0; i < x.size(); ++i)
    {
        const double residual = std::log(y[i]) - meanY - p * (std::log(x[i]) - meanX);
        residuals += residual * residual;
    }
    // 0/0 of two points: they say nothing of their scatter.
    const double standardError =
        x.size() > 2 ? std::sqrt(residuals / (n - 2) / xx) : std::numeric_limits<double>::quiet_NaN();
    return {std::exp(meanY - p * meanX), p, standardError};
}

} // namespace slosh
