// SPDX-License-Identifier: GPL-3.0-or-later
#include "statistics/Quantity.hpp"

#include "base/CaseError.hpp"
#include "dictionary/Dictionary.hpp"
#include "statistics/largestMean.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
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
            "there are " + std::to_string(series.size()) + " samples in the time asked for; " + what + " needs " +
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
        message << "the samples in the time asked for last " << length << " s, less than the period of " << period
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
    return {middle, periods > 1 ? std::sqrt(squares / (n - 1) / n) : unknown};
}

double largestMeanOf(const TimeSeries& series, double window)
{
    const double mean = largestMean(Integral(series), window);
    if (std::isnan(mean))
    {
        std::ostringstream message;
        message << "the samples in the time asked for last "
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

/// A quantity without an uncertainty of its own.
Quantity plain(double (*figure)(const TimeSeries&))
{
    return [figure](const TimeSeries& series) { return Estimate{figure(series), unknown}; };
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
        throw CaseError("the samples and the reference have no time in common");
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
        throw CaseError("the reference never moves: a difference relative to its motion has no meaning");
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
        throw CaseError("the samples and the reference have no time in common");
    }
    return static_cast<double>(inside) / static_cast<double>(all);
}

Quantity readQuantity(const Dictionary& dict)
{
    static const std::map<std::string, double (*)(const TimeSeries&)> plainOnes = {
        {"mean", mean},
        {"rms", rms},
        {"maximum", maximum},
        {"minimum", minimum},
        {"integral", [](const TimeSeries& series) { return integral(series, series.t.front(), series.t.back()); }},
        {"range", [](const TimeSeries& series) { return maximum(series) - minimum(series); }},
        {"timeOfMaximum", [](const TimeSeries& series) { return series.t[indexOfMaximum(series)]; }}};
    std::vector<std::string> valid = {"value", "meanPeak", "impulse", "firstTimeAbove", "largestMean"};
    for (const auto& one : plainOnes)
    {
        valid.push_back(one.first);
    }
    const std::string name = dict.choice("quantity", valid, "quantity");
    if (name == "value")
    {
        const double time = dict.scalar("time", unit::second);
        return [time](const TimeSeries& series) { return Estimate{series.at(time), unknown}; };
    }
    if (name == "firstTimeAbove")
    {
        const double level = dict.scalar("level", unit::none);
        return [level](const TimeSeries& series) { return Estimate{firstTimeAbove(series, level), unknown}; };
    }
    if (name == "largestMean")
    {
        const double window = dict.scalar("window", unit::second, positive);
        return [window](const TimeSeries& series) { return Estimate{largestMeanOf(series, window), unknown}; };
    }
    if (name == "meanPeak")
    {
        const double period = dict.scalar("period", unit::second, positive);
        return [period](const TimeSeries& series) { return meanPeak(series, period); };
    }
    if (name == "impulse")
    {
        const double before = dict.scalar("before", unit::second, notNegative);
        const double after = dict.scalar("after", unit::second, notNegative);
        const bool fromRise = dict.has("level");
        const double level = fromRise ? dict.scalar("level", unit::none) : 0;
        return [=](const TimeSeries& series)
        {
            const double instant = fromRise ? firstTimeAbove(series, level) : series.t[indexOfMaximum(series)];
            return Estimate{
                std::isnan(instant) ? unknown : integral(series, instant - before, instant + after), unknown};
        };
    }
    return plain(plainOnes.at(name));
}

void allowEntriesOfQuantities(const Dictionary& dict)
{
    dict.allow({"time", "period", "before", "after", "level", "window"});
}

} // namespace slosh
