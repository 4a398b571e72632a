// SPDX-License-Identifier: GPL-3.0-or-later
#include "statistics/TimeSeries.hpp"

#include "base/CaseError.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <optional>
#include <sstream>
#include <string>

namespace slosh
{

namespace
{

namespace fs = std::filesystem;

constexpr std::string_view separators = " \t,()\r";

/// The numbers of a line; nothing where one of its words is none.
std::optional<std::vector<double>> numbersOf(std::string_view line)
{
    std::vector<double> numbers;
    for (std::size_t begin = line.find_first_not_of(separators); begin != std::string_view::npos;)
    {
        const std::size_t end = std::min(line.find_first_of(separators, begin), line.size());
        double value = 0;
        const auto [last, error] = std::from_chars(line.data() + begin, line.data() + end, value);
        if (error != std::errc() || last != line.data() + end || !std::isfinite(value))
        {
            return std::nullopt;
        }
        numbers.push_back(value);
        begin = line.find_first_not_of(separators, end);
    }
    return numbers;
}

/// Appends a sample; what it repeats or goes back behind is dropped first.
void append(TimeSeries& series, double t, double value)
{
    while (!series.empty() && series.t.back() >= t)
    {
        series.t.pop_back();
        series.value.pop_back();
    }
    series.t.push_back(t);
    series.value.push_back(value);
}

} // namespace

TimeSeries TimeSeries::between(double begin, double end) const
{
    const auto first = std::lower_bound(t.begin(), t.end(), begin) - t.begin();
    const auto last = std::max(first, std::upper_bound(t.begin(), t.end(), end) - t.begin());
    return {{t.begin() + first, t.begin() + last}, {value.begin() + first, value.begin() + last}};
}

double TimeSeries::at(double time) const
{
    if (empty() || !(time >= t.front()) || !(time <= t.back()))
    {
        std::ostringstream message;
        message << "no sample at " << time << " s";
        if (!empty())
        {
            message << "; samples range from " << t.front() << " to " << t.back() << " s";
        }
        throw CaseError(message.str());
    }
    const auto k = static_cast<std::size_t>(std::upper_bound(t.begin(), t.end(), time) - t.begin());
    if (k == size())
    {
        return value.back();
    }
    const double part = (time - t[k - 1]) / (t[k] - t[k - 1]);
    return value[k - 1] + part * (value[k] - value[k - 1]);
}

TimeSeries readTimeSeries(const fs::path& file, int column, int timeColumn)
{
    std::ifstream in(file);
    if (!in || fs::is_directory(file))
    {
        throw CaseError(file.string() + ": cannot read the samples", CaseError::Kind::input);
    }
    TimeSeries series;
    int lineNumber = 0;
    for (std::string line; std::getline(in, line);)
    {
        ++lineNumber;
        const std::size_t begin = line.find_first_not_of(separators);
        if (begin == std::string::npos || line[begin] == '#')
        {
            continue;
        }
        const auto numbers = numbersOf(line);
        if (!numbers)
        {
            if (series.empty())
            {
                continue; // the columns' names
            }
            throw errorIn(placeIn(file.string(), lineNumber), "'" + line + "' is not a row of numbers");
        }
        if (std::max(column, timeColumn) >= static_cast<int>(numbers->size()) || std::min(column, timeColumn) < 0)
        {
            throw errorIn(
                placeIn(file.string(), lineNumber), "column " + std::to_string(std::max(column, timeColumn)) +
                                                        " (from 0) not found; there are " +
                                                        std::to_string(numbers->size())
            );
        }
        append(series, (*numbers)[timeColumn], (*numbers)[column]);
    }
    if (series.empty())
    {
        throw CaseError(file.string() + ": no samples found", CaseError::Kind::input);
    }
    return series;
}

TimeSeries readTimeSeries(const std::vector<fs::path>& parts, int column)
{
    TimeSeries all;
    for (const fs::path& file : parts)
    {
        const TimeSeries part = readTimeSeries(file, column);
        for (std::size_t k = 0; k < part.size(); ++k)
        {
            append(all, part.t[k], part.value[k]);
        }
    }
    return all;
}

TimeSeries readSamples(const fs::path& file, int column)
{
    struct Start
    {
        double time;
        fs::path file;
    };
    std::vector<Start> starts;
    std::error_code failure;
    for (const auto& item : fs::directory_iterator(file.parent_path(), failure))
    {
        const auto time = numbersOf(item.path().filename().string());
        const fs::path samples = item.path() / file.filename();
        if (time && time->size() == 1 && fs::exists(samples))
        {
            starts.push_back({time->front(), samples});
        }
    }
    if (starts.empty())
    {
        throw CaseError(
            "there are no samples \"" + (file.parent_path() / "<startTime>" / file.filename()).string() +
                "\"; has the case been run?",
            CaseError::Kind::input
        );
    }
    std::sort(starts.begin(), starts.end(), [](const Start& a, const Start& b) { return a.time < b.time; });
    std::vector<fs::path> parts;
    parts.reserve(starts.size());
    for (const Start& start : starts)
    {
        parts.push_back(start.file);
    }
    return readTimeSeries(parts, column);
}

} // namespace slosh
