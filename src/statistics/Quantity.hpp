// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "statistics/TimeSeries.hpp"

#include <functional>
#include <string>
#include <vector>

namespace slosh
{

class Dictionary;

/// A figure and its standard uncertainty, in the same unit; NaN where there is none.
struct Estimate
{
    double value = 0;
    double uncertainty = 0;
};

/// One figure made of a series.
using Quantity = std::function<Estimate(const TimeSeries&)>;

/// Makes the quantity a dictionary asks for:
///     quantity mean;                        // of the linear interpolant over time
///     quantity rms;                         // root mean square about the mean
///     quantity integral;                    // over time
///     quantity maximum;                     // minimum; range = maximum - minimum
///     quantity largestMean; window 0.02;    // of all windows of 0.02 s: statistics/largestMean.hpp
///     quantity timeOfMaximum;               // [s]
///     quantity firstTimeAbove; level 100;   // [s], linear between the samples; none (NaN) where all are below it
///     quantity value;      time 1;          // at an instant
///     quantity meanPeak;   period 1.57;     // mean of the highest value per whole period, counted from the first
///                                           // sample; its uncertainty is the standard error
///     quantity impulse;    before 0.02; after 0.08;  // integral from 0.02 s before the maximum to 0.08 s after it
///     quantity impulse;    level 500; before 0.02; after 0.08;  // the same around the first time above it, or none
/// Throws CaseError: an unknown quantity or a missing key now, too few samples when it is asked.
Quantity readQuantity(const Dictionary& dict);

/// Allows the entries of all quantities, as `dict` may come from the entry of another by $name.
void allowEntriesOfQuantities(const Dictionary& dict);

/// Integral of the linear interpolant over [begin, end], the series' ends at most.
double integral(const TimeSeries& series, double begin, double end);

// A series against another, at the series' own times within the reference's.

/// sqrt(sum (s - r)^2/sum (r - mean r)^2): 0 equal, 1 as far off as a reference that never moves.
double relativeDifference(const TimeSeries& series, const TimeSeries& reference);
/// The share of the samples within [low, high].
double shareInside(const TimeSeries& series, const TimeSeries& low, const TimeSeries& high);

} // namespace slosh
