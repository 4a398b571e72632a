// SPDX-License-Identifier: GPL-3.0-or-later
#include "statistics/Summary.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>

namespace slosh
{

namespace
{

double meanOfFirst(const std::vector<double>& values, std::size_t n)
{
    return std::accumulate(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(n), 0.0) /
           static_cast<double>(n);
}

} // namespace

Summary summarise(std::vector<double> values)
{
    constexpr double undefined = std::numeric_limits<double>::quiet_NaN();
    Summary summary{values.size(), undefined, undefined, undefined, undefined, undefined, undefined};
    if (values.empty())
    {
        return summary;
    }
    std::sort(values.begin(), values.end(), std::greater<>());
    const auto n = static_cast<double>(values.size());
    const auto highest = [&](double part)
    { return meanOfFirst(values, std::max<std::size_t>(1, static_cast<std::size_t>(std::lround(n * part)))); };
    summary.mean = meanOfFirst(values, values.size());
    summary.highestThird = highest(1.0 / 3);
    summary.highestTenth = highest(1.0 / 10);
    summary.maximum = values.front();
    if (values.size() > 1)
    {
        const double squares = std::accumulate(
            values.begin(), values.end(), 0.0,
            [&](double sum, double x) { return sum + (x - summary.mean) * (x - summary.mean); }
        );
        summary.standardDeviation = std::sqrt(squares / (n - 1));
        summary.standardError = summary.standardDeviation / std::sqrt(n);
    }
    return summary;
}

} // namespace slosh
