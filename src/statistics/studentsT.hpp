// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

namespace slosh
{

/// A(t|nu), the probability that a variable of Student's distribution with nu degrees of freedom lies within -t ... t,
/// t >= 0, by the finite sums in theta = atan(t/sqrt nu) of Abramowitz & Stegun 1964, Eqs. 26.7.3 and 26.7.4:
///     nu odd:  2/pi (theta + sin theta (cos theta + 2/3 cos^3 theta + ... + 2 4 ... (nu - 3)/(3 5 ... (nu - 2))
///     cos^(nu - 2) theta)), theta alone for nu = 1
///     nu even: sin theta (1 + 1/2 cos^2 theta + ... + 1 3 ... (nu - 3)/(2 4 ... (nu - 2)) cos^(nu - 2) theta)
/// Throws CaseError for nu = 0 or a t that is negative or no number.
double studentsProbability(double t, std::size_t nu);

/// The t with A(t|nu) = confidence: the mean of n = nu + 1 independent normal values with the standard error s lies
/// within t s of the true one so often. 0 < confidence < 1; throws CaseError otherwise, and for nu = 0.
double studentsT(double confidence, std::size_t nu);

} // namespace slosh
