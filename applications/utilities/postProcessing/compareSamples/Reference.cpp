// SPDX-License-Identifier: GPL-3.0-or-later
#include "Reference.hpp"

#include "exactSeries.hpp"

#include "statistics/comparisonKeys.hpp"
#include "statistics/movingAverage.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

namespace slosh
{

namespace
{

namespace fs = std::filesystem;

namespace reference
{

constexpr Key range{.name = "range", .example = "(0 5000)", .sentence = "(from to), instead of value"};
constexpr Key value{.name = "value", .example = "4400", .sentence = "instead of range", .alternative = true};
constexpr Key uncertainty{
    .name = "uncertainty",
    .leftOut = "none",
    .example = "250",
    .range = notNegative,
    .sentence = "uncertainty of value",
    .alternative = true};

constexpr Key file{
    .name = "file", .example = "\"lobovsky.csv\"", .sentence = "rows of numbers, separated by blanks, tabs or commas"};
constexpr Key timeColumn{.name = "timeColumn", .otherwise = "0", .range = notNegative};
constexpr Key column{
    .name = "column", .example = "1", .range = notNegative, .sentence = "column of the values, counted from 0"};
constexpr Key timeScale{.name = "timeScale", .otherwise = "1", .range = positive, .sentence = "factor of the times"};
constexpr Key timeShift{
    .name = "timeShift", .otherwise = "0", .unit = unit::second, .sentence = "added to the times after scaling"};
constexpr Key lowColumn{
    .name = "lowColumn",
    .leftOut = "no band",
    .example = "2",
    .range = notNegative,
    .sentence = "lower limit of a band, with highColumn"};
constexpr Key highColumn{
    .name = "highColumn",
    .leftOut = "no band",
    .example = "3",
    .range = notNegative,
    .sentence = "upper limit of the band"};

constexpr Key otherCase{.name = "case", .otherwise = ".", .sentence = "folder of the other case, relative to this one"};
constexpr Key timeStart{
    .name = "timeStart",
    .leftOut = "all; if timeEnd is also omitted, the time span of the samples",
    .example = "0",
    .unit = unit::second,
    .sentence = "time of the reference"};
constexpr Key timeEnd{
    .name = "timeEnd",
    .leftOut = "all; if timeStart is also omitted, the time span of the samples",
    .example = "5",
    .unit = unit::second,
    .sentence = "time of the reference"};

constexpr Key source{.name = "source", .leftOut = "none", .example = "\"origin of the reference\""};

} // namespace reference

Reference readStated(const Dictionary& dict, const Case&)
{
    Reference stated;
    if (dict.has(reference::range))
    {
        const auto ends = dict.scalars(reference::range);
        if (ends.size() != 2 || !(ends[0] < ends[1]))
        {
            throw dict.errorAt(reference::range, "is not a pair of increasing values; expected (from to)");
        }
        stated.range = {ends[0], ends[1]};
    }
    else
    {
        stated.figure = {
            dict.scalar(reference::value),
            dict.scalarOr(reference::uncertainty, std::numeric_limits<double>::quiet_NaN())};
    }
    return stated;
}

TimeSeries scaled(TimeSeries series, double timeScale, double timeShift, double scale, double offset)
{
    for (double& t : series.t)
    {
        t = timeScale * t + timeShift;
    }
    for (double& value : series.value)
    {
        value = scale * value + offset;
    }
    return series;
}

Reference readMeasured(const Dictionary& dict, const Case&)
{
    const std::string name = dict.word(reference::file);
    const char* folder = std::getenv("SLOSH_MEASURED");
    const int timeColumn = static_cast<int>(dict.label(reference::timeColumn));
    const double timeScale = dict.scalar(reference::timeScale);
    const double timeShift = dict.scalar(reference::timeShift);
    const double scale = dict.scalar(comparison::scale);
    const double offset = dict.scalar(comparison::offset);
    const int column = static_cast<int>(dict.label(reference::column));
    const bool hasBand = dict.has(reference::lowColumn) || dict.has(reference::highColumn);
    const int low = hasBand ? static_cast<int>(dict.label(reference::lowColumn)) : 0;
    const int high = hasBand ? static_cast<int>(dict.label(reference::highColumn)) : 0;

    const fs::path file = folder != nullptr ? fs::path(folder) / name : fs::path();
    if (folder == nullptr || !fs::exists(file))
    {
        throw MissingRecord(
            name + (folder == nullptr ? ": the environment variable SLOSH_MEASURED is not set"
                                      : " is not in " + std::string(folder) + " (SLOSH_MEASURED)")
        );
    }
    const auto read = [&](int k)
    { return scaled(readTimeSeries(file, k, timeColumn), timeScale, timeShift, scale, offset); };
    Reference measured;
    measured.series = read(column);
    if (hasBand)
    {
        measured.band = {read(low), read(high)};
    }
    return measured;
}

Reference readSamplesOfCase(const Dictionary& dict, const Case& theCase)
{
    const fs::path other = theCase.root() / dict.word(reference::otherCase);
    Reference ofCase;
    ofCase.series = scaled(
        readSamples(
            other / "postProcessing" / dict.word(comparison::samples), static_cast<int>(dict.label(comparison::column))
        ),
        1, 0, dict.scalar(comparison::scale), dict.scalar(comparison::offset)
    );
    ofCase.series = movingAverage(*ofCase.series, dict.scalar(comparison::filter));
    ofCase.timeStart = dict.scalarOr(reference::timeStart, ofCase.timeStart);
    ofCase.timeEnd = dict.scalarOr(reference::timeEnd, ofCase.timeEnd);
    return ofCase;
}

using ReferenceType = Choice<Reference (*)(const Dictionary& dict, const Case& theCase)>;

/// Those that are no exact solutions.
const std::vector<ReferenceType>& givenReferences()
{
    using namespace reference;
    static const std::vector<ReferenceType> table = {
        {"none", "the figure only", [](const Dictionary&, const Case&) { return Reference(); }},
        {"stated", "a stated value", readStated,
         [] {
             return Keys{range, value, uncertainty};
         }},
        {"measured", "a record in the folder of the environment variable SLOSH_MEASURED; not compared without it",
         readMeasured,
         []
         {
             return Keys{file,      reference::column, comparison::scale, comparison::offset, timeColumn,
                         timeScale, timeShift,         lowColumn,         highColumn};
         }},
        {"samples", "samples of another case, or of this one", readSamplesOfCase,
         []
         {
             return Keys{otherCase,          comparison::samples, comparison::column,   comparison::scale,
                         comparison::offset, comparison::filter,  reference::timeStart, reference::timeEnd};
         }}};
    return table;
}

namespace reference
{

constexpr Key type{
    .name = "type",
    .example = "stated",
    .options = []
    {
        Options options = optionsOf(givenReferences());
        const Options exact = optionsOf(exactSeries());
        options.insert(options.end(), exact.begin(), exact.end());
        return options;
    }};
constexpr Key dictionary{.name = "reference", .entries = [] { return Keys{type, source}; }};

} // namespace reference

} // namespace

Reference readReference(const Dictionary& dict, const Case& theCase, const TimeSeries& samples)
{
    const std::string source = dict.wordOr(reference::source, "");
    const std::string type = dict.choice(reference::type, "type of reference");
    Reference read;
    const auto exact = std::find_if(
        exactSeries().begin(), exactSeries().end(), [&](const ExactSeries& one) { return one.name == type; }
    );
    if (exact != exactSeries().end())
    {
        read.series = exact->read(dict, theCase, samples);
    }
    else
    {
        read = choiceNamed(givenReferences(), type).read(dict, theCase);
    }
    read.source = source;
    dict.refuseIdle(reference::dictionary.entries());
    return read;
}

Key referenceKey()
{
    return reference::dictionary;
}

} // namespace slosh
