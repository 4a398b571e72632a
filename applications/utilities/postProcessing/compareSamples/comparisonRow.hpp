// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Reference.hpp"

#include <limits>
#include <string>

namespace slosh
{

/// One comparison, as it stands in the table.
struct ComparisonRow
{
    std::string description, figure, reference, error, source;
    /// What `error` says, as a number: (figure - reference)/|reference|; the distance from a stated range or from a
    /// reference of 0, in the figure's unit; for an instant seconds, for a ratio its distance from the stated one. NaN:
    /// none.
    double off = std::numeric_limits<double>::quiet_NaN();
    /// `figure` as a number, and its standard uncertainty; NaN: none.
    double value = std::numeric_limits<double>::quiet_NaN();
    double uncertainty = std::numeric_limits<double>::quiet_NaN();
    std::size_t count = 0; ///< of the independent values whose mean the figure is; 0: it is no such mean
    /// The same quantity of the reference, as a number, and its standard uncertainty; NaN: none.
    double expected = std::numeric_limits<double>::quiet_NaN();
    double expectedUncertainty = std::numeric_limits<double>::quiet_NaN();
};

/// Applies the quantity that `dict` asks for to the samples and to the reference. Throws CaseError.
ComparisonRow compareWith(const Reference& reference, const TimeSeries& samples, const Dictionary& dict);

} // namespace slosh
