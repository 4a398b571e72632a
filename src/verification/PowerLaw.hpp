// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

namespace slosh
{

/// y = C x^p, as an error is of the spacing, or a run time.
struct PowerLaw
{
    double C = 0; ///< in the unit of y/x^p
    double p = 0;
    double standardError = 0; ///< of p, from the scatter about the line in logarithms; NaN of two points

    double operator()(double x) const;
    /// The x where y is reached, (y/C)^(1/p); NaN for p = 0, where y does not depend on x.
    double inverse(double y) const;
};

/// The line of least squares through (log x, log y), two points or more:
///     p = sum (X - mean X)(Y - mean Y)/sum (X - mean X)^2,  standard error^2 = sum residual^2/((n - 2) sum (X - mean
///     X)^2).
/// Throws CaseError: fewer, of different numbers, values that are not > 0, x all alike.
PowerLaw fitPowerLaw(const std::vector<double>& x, const std::vector<double>& y);

} // namespace slosh
