// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

namespace slosh
{

/// The Weibull distribution (Weibull 1951, Journal of Applied Mechanics 18, 293-297):
///     P(X > x) = exp(-((x - delta)/eta)^beta),   x >= delta
/// With delta = 0 it is the two-parameter, with beta = 1 the exponential, with beta = 2 the Rayleigh distribution.
struct Weibull
{
    double location = 0; ///< delta, in the unit of x
    double scale = 1;    ///< eta > 0, in the unit of x
    double shape = 1;    ///< beta > 0

    /// P(X > x).
    double exceedance(double x) const { return x <= location ? 1 : std::exp(-std::pow((x - location) / scale, shape)); }
    /// The x with P(X > x) = probability, 0 < probability < 1: delta + eta (-ln probability)^(1/beta).
    double valueExceededBy(double probability) const
    {
        return location + scale * std::pow(-std::log(probability), 1 / shape);
    }
};

} // namespace slosh
