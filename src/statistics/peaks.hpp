// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "statistics/TimeSeries.hpp"

#include <limits>
#include <vector>

namespace slosh
{

/// A peak of a series p(t), linear between its samples. t_- and t_+ are the last time before and the first time after
/// the peak where p is half the peak value, which counts from 0:
///     rise time  2 (t_peak - t_-),  decay time  2 (t_+ - t_peak),  impulse  int_{t_-}^{t_+} p dt
/// These are the sides of the triangle through the peak and its half values, to which impact pressures are idealised
/// (Graczyk & Moan 2008, Ocean Engineering 35, 834-855; the triangular impulses of Det Norske Veritas, Classification
/// Notes 30.9). A triangle from zero has those very times and the impulse 3/8 p_peak (rise + decay): three quarters of
/// its area lie between the half values.
///
/// A time is NaN where p does not fall to half on that side before it exceeds the peak or the record ends; the impulse
/// is NaN where either is.
struct Peak
{
    double time = 0;      ///< [s]; the first sample of a flat top
    double value = 0;     ///< in the unit of the samples
    double riseTime = 0;  ///< [s]
    double decayTime = 0; ///< [s]
    double impulse = 0;   ///< in the unit of the samples times s
};

/// The peaks over a threshold, in the order of time: local maxima above (not at) `threshold`, thinned until no two are
/// nearer than `separation` [s]. The largest is kept first, then the largest of those that are not too near to one
/// already kept, and so on (the earlier of two equals): every maximum left out is nearer than `separation` to a kept
/// one that is no smaller. The first and last sample are no peaks, as it is unknown whether the series rises beyond.
/// Maxima outside begin <= t <= end [s] count for nothing; times and impulse of those inside are still measured on all
/// of the series.
/// Throws CaseError for a threshold or a separation that is negative or no number.
std::vector<Peak> findPeaks(
    const TimeSeries& series, double threshold, double separation,
    double begin = -std::numeric_limits<double>::infinity(), double end = std::numeric_limits<double>::infinity()
);

/// For each of the peaks of a series the largest mean over a window of the length w [s] that holds the peak's instant,
///     max_t 1/w int_t^{t + w} p dt,   t_peak - w <= t <= t_peak,
/// the whole window within the record, by largestMean(); NaN where the record is shorter than w. Peaks that are nearer
/// to each other than w may share a window.
std::vector<double> largestMeansAround(const std::vector<Peak>& peaks, const TimeSeries& series, double window);

} // namespace slosh
