// SPDX-License-Identifier: GPL-3.0-or-later
#include "statistics/Quantity.hpp"

#include "base/CaseError.hpp"
#include "dictionary/Choice.hpp"
#include "statistics/comparisonKeys.hpp"
#include "statistics/largestMean.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <sstream>

namespace slosh
{

namespace
{

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

void requireSamples(const TimeSeries& series, std::size_t least, const std::string& what)
{
    if (series.size() < least)
    {
        throw CaseError(
            std::to_string(series.size()) + " samples between timeStart and timeEnd; " + what + " needs at least " +
            std::to_string(least)
        );
    }
}

std::size_t indexOfMaximum(const TimeSeries& series)
{
    requireSamples(series, 1, "a maximum");
    return static_cast<std::size_t>(std::max_element(series.value.begin(), series.value.end()) - series.value.begin());
}

double maximum(const TimeSeries& series)
{
    return series.value[indexOfMaximum(series)];
}

double minimum(const TimeSeries& series)
{
    requireSamples(series, 1, "a minimum");
    return *std::min_element(series.value.begin(), series.value.end());
}

double mean(const TimeSeries& series)
{
    requireSamples(series, 2, "a mean");
    return integral(series, series.t.front(), series.t.back()) / (series.t.back() - series.t.front());
}

double rms(const TimeSeries& series)
{
    TimeSeries squares = series;
    const double middle = mean(series);
    std::transform(
        series.value.begin(), series.value.end(), squares.value.begin(),
        [&](double x) { return (x - middle) * (x - middle); }
    );
    return std::sqrt(mean(squares));
}

Estimate meanPeak(const TimeSeries& series, double period)
{
    requireSamples(series, 2, "a mean of peaks");
    // The last sample may end a period by a rounding.
    const double length = series.t.back() - series.t.front();
    const auto periods = static_cast<std::size_t>(std::floor(length / period + 1e-6));
    if (periods == 0)
    {
        std::ostringstream message;
        message << "the samples in the requested time span last " << length << " s, less than the period of " << period
                << " s";
        throw CaseError(message.str());
    }
    std::vector<double> peaks(periods, -std::numeric_limits<double>::infinity());
    for (std::size_t i = 0; i < series.size(); ++i)
    {
        const auto k = static_cast<std::size_t>((series.t[i] - series.t.front()) / period);
        if (k < periods)
        {
            peaks[k] = std::max(peaks[k], series.value[i]);
        }
    }
    const auto n = static_cast<double>(periods);
    const double middle = std::accumulate(peaks.begin(), peaks.end(), 0.0) / n;
    double squares = 0;
    for (const double peak : peaks)
    {
        squares += (peak - middle) * (peak - middle);
    }
    return {middle, periods > 1 ? std::sqrt(squares / (n - 1) / n) : unknown, periods};
}

double largestMeanOf(const TimeSeries& series, double window)
{
    const double mean = largestMean(Integral(series), window);
    if (std::isnan(mean))
    {
        std::ostringstream message;
        message << "the samples in the requested time span last "
                << (series.empty() ? 0 : series.t.back() - series.t.front()) << " s, less than the window of " << window
                << " s";
        throw CaseError(message.str());
    }
    return mean;
}

double firstTimeAbove(const TimeSeries& series, double level)
{
    requireSamples(series, 1, "a time above a level");
    const auto above = std::find_if(series.value.begin(), series.value.end(), [&](double x) { return x > level; });
    if (above == series.value.end())
    {
        return unknown;
    }
    const auto k = static_cast<std::size_t>(above - series.value.begin());
    if (k == 0)
    {
        return series.t[0];
    }
    const double before = series.value[k - 1];
    return series.t[k - 1] + (level - before) / (*above - before) * (series.t[k] - series.t[k - 1]);
}

double wholeIntegral(const TimeSeries& series)
{
    return integral(series, series.t.front(), series.t.back());
}

double height(const TimeSeries& series)
{
    return maximum(series) - minimum(series);
}

double timeOfMaximum(const TimeSeries& series)
{
    return series.t[indexOfMaximum(series)];
}

namespace quantityEntries
{

constexpr Key time{.name = "time", .example = "1", .unit = unit::second, .sentence = "time of the value"};
constexpr Key level{.name = "level", .example = "100", .sentence = "in the unit of the samples"};
constexpr Key window{
    .name = "window", .example = "0.02", .unit = unit::second, .range = positive, .sentence = "length of the window"};
constexpr Key period{
    .name = "period",
    .example = "0.01",
    .unit = unit::second,
    .range = positive,
    .sentence = "period of meanPeak, counted from the first sample"};
constexpr Key before{
    .name = "before",
    .example = "0.02",
    .unit = unit::second,
    .range = notNegative,
    .sentence = "start of the integral before the maximum"};
constexpr Key after{
    .name = "after",
    .example = "0.08",
    .unit = unit::second,
    .range = notNegative,
    .sentence = "end of the integral after the maximum"};
constexpr Key rise{
    .name = "level",
    .leftOut = "none",
    .example = "500",
    .sentence =
        "integrate around the first time above this level instead of the maximum; no figure if all samples are below"};

} // namespace quantityEntries

/// A quantity without an uncertainty of its own.
template <double (*figure)(const TimeSeries&)>
Quantity plain(const Dictionary&)
{
    return [](const TimeSeries& series) { return Estimate{figure(series), unknown}; };
}

Quantity readValue(const Dictionary& dict)
{
    const double time = dict.scalar(quantityEntries::time);
    return [time](const TimeSeries& series) { return Estimate{series.at(time), unknown}; };
}

Quantity readMeanPeak(const Dictionary& dict)
{
    const double period = dict.scalar(quantityEntries::period);
    return [period](const TimeSeries& series) { return meanPeak(series, period); };
}

Quantity readImpulse(const Dictionary& dict)
{
    const double before = dict.scalar(quantityEntries::before);
    const double after = dict.scalar(quantityEntries::after);
    const bool fromRise = dict.has(quantityEntries::rise);
    const double level = fromRise ? dict.scalar(quantityEntries::rise) : 0;
    return [=](const TimeSeries& series)
    {
        const double instant = fromRise ? firstTimeAbove(series, level) : timeOfMaximum(series);
        return Estimate{std::isnan(instant) ? unknown : integral(series, instant - before, instant + after), unknown};
    };
}

Quantity readLargestMean(const Dictionary& dict)
{
    const double window = dict.scalar(quantityEntries::window);
    return [window](const TimeSeries& series) { return Estimate{largestMeanOf(series, window), unknown}; };
}

Quantity readFirstTimeAbove(const Dictionary& dict)
{
    const double level = dict.scalar(quantityEntries::level);
    return [level](const TimeSeries& series) { return Estimate{firstTimeAbove(series, level), unknown}; };
}

using QuantityChoice = Choice<Quantity (*)(const Dictionary&)>;

const std::vector<QuantityChoice>& quantities()
{
    using namespace quantityEntries;
    static const std::vector<QuantityChoice> table = {
        {"mean", "time average, linear between the samples", plain<mean>},
        {"rms", "root mean square about the mean", plain<rms>},
        {"maximum", "", plain<maximum>},
        {"minimum", "", plain<minimum>},
        {"range", "maximum - minimum", plain<height>},
        {"timeOfMaximum", "an instant, [s]", plain<timeOfMaximum>},
        {"value", "at an instant", readValue, [] { return Keys{time}; }},
        {"meanPeak", "mean of the highest value per whole period, with its standard error", readMeanPeak,
         [] { return Keys{period}; }},
        {"impulse", "integral around the maximum", readImpulse,
         [] {
             return Keys{before, after, rise};
         }},
        {"largestMean",
         "largest mean over any window in the time span, by the trapezoidal rule; a reference series is treated in the "
         "same way",
         readLargestMean, [] { return Keys{window}; }},
        {"integral", "over the whole time span", plain<wholeIntegral>},
        {"firstTimeAbove", "an instant, [s], linear between the samples; no figure if all samples are below the level",
         readFirstTimeAbove, [] { return Keys{level}; }}};
    return table;
}

} // namespace

double integral(const TimeSeries& series, double begin, double end)
{
    requireSamples(series, 1, "an integral");
    begin = std::max(begin, series.t.front());
    end = std::min(end, series.t.back());
    return begin < end ? Integral(series).between(begin, end) : 0;
}

double relativeDifference(const TimeSeries& series, const TimeSeries& reference)
{
    requireSamples(reference, 2, "a comparison");
    std::vector<double> off, exact;
    for (std::size_t i = 0; i < series.size(); ++i)
    {
        if (series.t[i] >= reference.t.front() && series.t[i] <= reference.t.back())
        {
            exact.push_back(reference.at(series.t[i]));
            off.push_back(series.value[i] - exact.back());
        }
    }
    if (exact.empty())
    {
        throw CaseError("samples and reference do not overlap in time");
    }
    const double middle = std::accumulate(exact.begin(), exact.end(), 0.0) / static_cast<double>(exact.size());
    double numerator = 0, denominator = 0;
    for (std::size_t i = 0; i < exact.size(); ++i)
    {
        numerator += off[i] * off[i];
        denominator += (exact[i] - middle) * (exact[i] - middle);
    }
    if (!(denominator > 0))
    {
        throw CaseError("the reference is constant: a difference relative to its variation is not defined");
    }
    return std::sqrt(numerator / denominator);
}

double shareInside(const TimeSeries& series, const TimeSeries& low, const TimeSeries& high)
{
    std::size_t inside = 0, all = 0;
    for (std::size_t i = 0; i < series.size(); ++i)
    {
        const double t = series.t[i];
        if (t >= low.t.front() && t <= low.t.back())
        {
            ++all;
            inside += series.value[i] >= low.at(t) && series.value[i] <= high.at(t);
        }
    }
    if (all == 0)
    {
        throw CaseError("samples and reference do not overlap in time");
    }
    return static_cast<double>(inside) / static_cast<double>(all);
}

Options quantityOptions()
{
    Options options = optionsOf(quantities());
    options.push_back({"difference", "sqrt(sum (s - r)^2/sum (r - mean r)^2), r the reference series"});
    options.push_back({"shareInside", "fraction of the samples inside the band of a reference series"});
    return options;
}

Quantity readQuantity(const Dictionary& dict)
{
    return choose(dict, comparison::quantity.name, quantities(), "quantity").read(dict);
}

} // namespace slosh
