// SPDX-License-Identifier: GPL-3.0-or-later
#include "statistics/peaks.hpp"

#include "base/CaseError.hpp"
#include "statistics/largestMean.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <set>
#include <string>
#include <utility>

namespace slosh
{

namespace
{

/// The samples that are local maxima above the threshold, the first one of a flat top.
std::vector<std::size_t> maximaAbove(const TimeSeries& series, double threshold)
{
    std::vector<std::size_t> maxima;
    const auto& p = series.value;
    for (std::size_t k = 1; k < p.size(); ++k)
    {
        if (p[k] <= threshold || p[k] <= p[k - 1])
        {
            continue;
        }
        std::size_t after = k + 1;
        while (after < p.size() && p[after] == p[k])
        {
            ++after;
        }
        if (after < p.size() && p[after] < p[k])
        {
            maxima.push_back(k);
        }
    }
    return maxima;
}

/// Those that are kept when the largest go first and no two are nearer than `separation`, in the order of time.
std::vector<std::size_t> thinned(const TimeSeries& series, std::vector<std::size_t> maxima, double separation)
{
    std::stable_sort(
        maxima.begin(), maxima.end(), [&](std::size_t a, std::size_t b) { return series.value[a] > series.value[b]; }
    );
    std::set<std::size_t> kept;
    for (const std::size_t k : maxima)
    {
        const auto after = kept.lower_bound(k);
        const bool nearNext = after != kept.end() && series.t[*after] - series.t[k] < separation;
        const bool nearLast = after != kept.begin() && series.t[k] - series.t[*std::prev(after)] < separation;
        if (!nearNext && !nearLast)
        {
            kept.insert(after, k);
        }
    }
    return {kept.begin(), kept.end()};
}

/// Where the series falls to half its value at sample `peak`, going back (step -1) or on (+1).
double halfValueTime(const TimeSeries& series, std::size_t peak, std::ptrdiff_t step)
{
    const auto& p = series.value;
    const double half = p[peak] / 2;
    std::size_t last = peak;
    while (step > 0 ? last + 1 < p.size() : last > 0)
    {
        const std::size_t k = last + static_cast<std::size_t>(step);
        if (p[k] > p[peak])
        {
            break;
        }
        if (p[k] <= half)
        {
            return series.t[last] + (p[last] - half) / (p[last] - p[k]) * (series.t[k] - series.t[last]);
        }
        last = k;
    }
    return std::numeric_limits<double>::quiet_NaN();
}

} // namespace

std::vector<Peak> findPeaks(const TimeSeries& series, double threshold, double separation, double begin, double end)
{
    if (!(threshold >= 0) || !(separation >= 0))
    {
        throw CaseError(
            "peaks above " + std::to_string(threshold) + ", " + std::to_string(separation) +
            " s apart; expected both >= 0"
        );
    }
    std::vector<Peak> peaks;
    auto maxima = maximaAbove(series, threshold);
    std::erase_if(maxima, [&](std::size_t k) { return series.t[k] < begin || series.t[k] > end; });
    const Integral integral(series);
    for (const std::size_t k : thinned(series, std::move(maxima), separation))
    {
        const double t = series.t[k];
        const double before = halfValueTime(series, k, -1), after = halfValueTime(series, k, 1);
        const double impulse = std::isnan(before + after) ? before + after : integral.between(before, after);
        peaks.push_back({t, series.value[k], 2 * (t - before), 2 * (after - t), impulse});
    }
    return peaks;
}

std::vector<double> largestMeansAround(const std::vector<Peak>& peaks, const TimeSeries& series, double window)
{
    const Integral integral(series);
    std::vector<double> means;
    means.reserve(peaks.size());
    for (const Peak& peak : peaks)
    {
        means.push_back(largestMean(integral, window, peak.time - window, peak.time + window));
    }
    return means;
}

} // namespace slosh
