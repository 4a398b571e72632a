// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "statistics/Integral.hpp"

#include <limits>

namespace slosh
{

/// The largest mean of a series, linear between its samples, over a window of the length w [s]:
///     max_t 1/w int_t^{t + w} p dt,   t >= begin, t + w <= end, the whole window within the record
/// in the unit of the samples. The integral is the trapezoidal rule over the samples, whatever their spacing, with
/// interpolated values at both ends of the window. Between the places where an end of the window meets a sample the
/// mean is a parabola in t, so that the maximum is exact for this interpolant: t need not be a sample, nor is the
/// largest sample always in the middle. It is never above the largest sample, to which it goes with w to 0; a window
/// shorter than the distance of samples says no more than that. (The maximum of movingAverage() is another figure: its
/// windows are centred on samples and shrink at the ends of the record.)
///
/// NaN where no such window is within the record. Throws CaseError where w is not > 0.
double largestMean(
    const Integral& integral, double window, double begin = -std::numeric_limits<double>::infinity(),
    double end = std::numeric_limits<double>::infinity()
);

} // namespace slosh
