// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "verification/RefinementFit.hpp"

namespace slosh
{

/// What a figure, or a series, computed with four or more spacings says of its own error, with 95 % confidence: the
/// band phi_1 +- U about the value phi_1 of the finest spacing h_1, in the unit of phi. After Eca & Hoekstra 2014, J.
/// Comput. Phys. 262, 104-130: least-squares fits, their selection, the data range and the safety factor. What is added
/// to it says so.
struct NumericalUncertainty
{
    /// The observed order p, of the better of the two fits with one fitted exponent (with and without weights).
    double order = 0;
    /// Whether 1/2 <= p <= q, q the order of the scheme. Then `fit` is that fit; else the one of the smallest sigma
    /// among those with the exponents 1; q; and, for p < 1/2, both.
    bool isOrderKept = false;
    RefinementFit fit;
    double dataRange = 0; ///< Delta = max |phi_i - phi_j|/(n - 1)
    /// Fs = 1.25 where 1/2 <= p < q + 0.1, sigma < Delta and (added) the scatter is smaller than the error; else 3.
    double safetyFactor = 0;
    double error = 0;     ///< e = |phi(h_1) - phi0| of the fit
    double deviation = 0; ///< |phi_1 - phi(h_1)|
    /// Added: the largest |phi0 - phi0'| where the fit with the exponents 1 and q has the limit phi0' and the smaller
    /// sigma; 0 where it has none. A mixed order looks like a single one that is too high.
    double otherLimit = 0;
    double change = 0; ///< |phi_2 - phi_1|
    /// Added: whether `discretisation` was raised to `change`. It is not where the fit has earned less: Fs = 1.25 and
    /// sigma < Delta/10.
    bool isChange = false;

    /// U_d = Fs e + sigma + deviation + otherLimit where sigma <= Delta, else 3 sigma/Delta times that with Fs = 1.
    double discretisation = 0;
    /// U_s, added: of figures that scatter by +- s_i, sqrt(s_1^2 + sum_i d_i^2), d_i the larger change of e where phi_i
    /// is moved by s_i and by -s_i; 0 where they do not.
    double scatter = 0;

    double total() const; ///< U = sqrt(U_d^2 + U_s^2)
    /// Whether the figures follow the fit, sigma <= Delta, or do not change at all: only then does U_d fall with the
    /// spacing as the fit's error.
    bool isFollowed() const { return fit.standardDeviation <= dataRange || dataRange == 0; }
};

inline constexpr double lowestOrder = 0.5, orderTolerance = 0.1; ///< that p may be above q and still be the scheme's
inline constexpr std::size_t fewestSpacings = 4; ///< of an order: three parameters and something to judge them by

/// The uncertainty of the finest figure. `scatter`: the half width s_i of the 95 % interval of each figure, in its
/// unit, or nothing. `schemeOrder`: q >= 1. Throws CaseError: fewer than four spacings, spacings that do not rise from
/// the finest, another number of figures or of half widths, a scatter of series.
NumericalUncertainty
numericalUncertainty(const Refinement& study, const std::vector<double>& scatter, double schemeOrder);

} // namespace slosh
