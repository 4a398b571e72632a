// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Run.hpp"

namespace slosh
{

/// One run in the table of one comparison. What is unknown is NaN.
struct Row
{
    const Run* run = nullptr;
    double spacing = Outcome::unknown; ///< [m]
    double figure = Outcome::unknown;
    double error = Outcome::unknown;
    /// Observed order to the next coarser run of the scheme, log(error_coarse/error)/log(dx_coarse/dx).
    double order = Outcome::unknown;
    double standardError = Outcome::unknown; ///< of a figure that is a mean over periods
    std::size_t count = 0;                   ///< of these

    bool hasError() const { return error > 0 && run->outcome.finished(); }
};

/// The errors of all runs in one comparison: rows by scheme, within it from the coarsest to the finest.
struct ErrorTable
{
    const Comparison* comparison = nullptr;
    std::vector<Row> rows;

    std::vector<std::string> schemes() const;  ///< in the order of the rows
    std::vector<std::string> families() const; ///< in the order of the rows
    std::vector<std::string> schemesOf(const std::string& family) const;
    std::vector<const Row*> rowsOf(const std::string& scheme) const;       ///< coarsest first
    std::vector<const Row*> rowsOfFamily(const std::string& family) const; ///< of all members, coarsest first
    std::vector<const Row*> paretoFront() const; ///< of CPU seconds and errors > 0, cheapest first
};

/// The table of the comparison number `index`; where its reference is Richardson's extrapolation, errors are made here:
/// |figure/f0 - 1| with the limit f0 of the fit to all spacings of the family (FigureUncertainty), NaN where these are
/// fewer than four.
ErrorTable errorTable(
    const std::vector<Run>& runs, const std::vector<Comparison>& comparisons, std::size_t index, double schemeOrder
);

} // namespace slosh
