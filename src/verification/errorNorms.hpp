// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

namespace slosh
{

/// How far values are from those they should be, both over the size of the latter.
struct ErrorNorms
{
    double L2 = 0;   ///< sqrt(sum (f - e)^2/sum e^2)
    double Linf = 0; ///< max |f - e|/max |e|
};

/// Norms of `found` against `expected`. Throws CaseError: of different lengths, empty, all expected values 0.
ErrorNorms errorNorms(const std::vector<double>& found, const std::vector<double>& expected);

/// The exponent p of error = C dx^p.
struct ObservedOrder
{
    double p = 0;
    double standardError = 0; ///< of p, from the scatter about the line; 0 for errors that are exactly a power
};

/// The line of least squares through (log dx, log error), three or more of them. Throws CaseError: fewer, different
/// lengths, values that are not > 0, spacings all alike.
ObservedOrder observedOrder(const std::vector<double>& dx, const std::vector<double>& error);

} // namespace slosh
