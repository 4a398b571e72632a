// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "dictionary/Dictionary.hpp"
#include "statistics/TimeSeries.hpp"

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace slosh
{

/// A figure and its standard uncertainty, in the same unit; NaN where there is none.
struct Estimate
{
    double value = 0;
    double uncertainty = 0;
    std::size_t count = 0; ///< of the independent values whose mean it is; 0: it is no such mean
};

/// One figure made of a series.
using Quantity = std::function<Estimate(const TimeSeries&)>;

/// What can be asked for: the quantities of readQuantity() and, of two series, difference and shareInside.
Options quantityOptions();

/// The quantity of one series that a dictionary asks for. Throws CaseError: an unknown one or a missing key now, too
/// few samples when it is asked.
Quantity readQuantity(const Dictionary& dict);

/// Integral of the linear interpolant over [begin, end], the series' ends at most.
double integral(const TimeSeries& series, double begin, double end);

// A series against another, at the series' own times within the reference's.

/// sqrt(sum (s - r)^2/sum (r - mean r)^2): 0 equal, 1 as far off as a reference that never moves.
double relativeDifference(const TimeSeries& series, const TimeSeries& reference);
/// The share of the samples within [low, high].
double shareInside(const TimeSeries& series, const TimeSeries& low, const TimeSeries& high);

} // namespace slosh
