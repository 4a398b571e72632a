// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "CaseState.hpp"

#include "statistics/Summary.hpp"

namespace slosh
{

/// One result over the members of an ensemble: cases that differ only along the axes that sweepDict names in
/// `ensemble`, such as by a thousandth of the amplitude, and with the same right to be the
/// answer. Over its n members m = sum x/n, s = sqrt(sum (x - m)^2/(n - 1)), the standard error of m is s/sqrt(n).
struct Ensemble
{
    std::vector<std::string> values; ///< of each axis that is not of members, as its label
    std::size_t result = 0;
    Summary ours;            ///< of the members that have the result
    std::size_t missing = 0; ///< members that have none
    /// The mean over the members of what they are held against, and of its standard uncertainty (of runs somebody has
    /// measured their standard deviation); NaN: none.
    double reference = Outcome::unknown, referenceUncertainty = Outcome::unknown;

    double difference() const { return ours.mean - reference; }
    /// sqrt(standard error^2 + uncertainty of the reference^2); NaN where one of them is unknown.
    double combinedUncertainty() const;
};

/// Every result of every ensemble, in the order of the cases.
std::vector<Ensemble> ensemblesOf(const Sweep& sweep, const std::vector<CaseState>& states);

/// A row for each, cells separated by tabs under a line of names: values of the axes that are not of members, result,
/// unit, members, missing, mean, standard deviation, standard error, reference, its uncertainty, difference, combined
/// uncertainty, whether |difference| is within it (yes, no), source of the reference. What is not known is nan.
std::string ensembleTable(const Sweep& sweep, const std::vector<Ensemble>& ensembles);

/// The same as a sentence each.
std::string ensembleText(const Sweep& sweep, const std::vector<Ensemble>& ensembles);

/// Warnings, a line each, of members of an ensemble that have the very same results: a spacing that was adjusted to
/// the tank, say, has made one run of two, and the deviation is too small.
std::string sameMembers(const Sweep& sweep, const std::vector<CaseState>& states);

} // namespace slosh
