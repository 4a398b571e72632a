// SPDX-License-Identifier: GPL-3.0-or-later
#include "statistics/largestMean.hpp"

#include "base/CaseError.hpp"

#include <algorithm>
#include <iterator>
#include <string>
#include <vector>

namespace slosh
{

namespace
{

/// The beginnings from `first` to `last` at which one end of the window meets a sample, in order, with both of these.
std::vector<double> knots(const TimeSeries& series, double window, double first, double last)
{
    std::vector<double> all{first, last};
    for (const double shift : {0.0, window})
    {
        const auto from = std::upper_bound(series.t.begin(), series.t.end(), first + shift);
        const auto to = std::lower_bound(from, series.t.end(), last + shift);
        std::transform(from, to, std::back_inserter(all), [&](double t) { return std::clamp(t - shift, first, last); });
    }
    std::sort(all.begin(), all.end());
    return all;
}

} // namespace

double largestMean(const Integral& integral, double window, double begin, double end)
{
    if (!(window > 0))
    {
        throw CaseError("a mean over a window of " + std::to_string(window) + " s; expected > 0");
    }
    const TimeSeries& series = integral.series();
    double largest = std::numeric_limits<double>::quiet_NaN();
    if (series.empty())
    {
        return largest;
    }
    const double first = std::max(begin, series.t.front());
    const double latest = std::min(end, series.t.back()) - window;
    if (!(first <= latest + 1e-9 * window)) // a record as long as the window has one, whatever rounding says
    {
        return largest;
    }
    const double last = std::max(first, latest);
    // Nor may rounding take the window beyond the record.
    const auto endOf = [&](double t) { return std::min(t + window, series.t.back()); };
    const auto consider = [&](double t)
    {
        const double mean = integral.between(t, endOf(t)) / (endOf(t) - t);
        largest = largest >= mean ? largest : mean;
    };
    const auto slope = [&](double t) { return series.at(endOf(t)) - series.at(t); };
    double before = first, slopeBefore = slope(first);
    for (const double t : knots(series, window, first, last))
    {
        const double slopeNow = slope(t);
        if (slopeBefore > 0 && slopeNow < 0)
        {
            consider(before + (t - before) * slopeBefore / (slopeBefore - slopeNow));
        }
        consider(t);
        before = t;
        slopeBefore = slopeNow;
    }
    return largest;
}

} // namespace slosh
