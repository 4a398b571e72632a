// SPDX-License-Identifier: GPL-3.0-or-later
#include "PeakQuery.hpp"

#include "statistics/comparisonKeys.hpp"

namespace slosh
{

namespace
{

constexpr Unit ofSamples{{}, "the unit of the samples"};
constexpr Range probability{0, 1, false, false};

namespace peakStatisticsDict
{

constexpr Key column{
    .name = "column",
    .otherwise = "1",
    .range = between(1, 1e6),
    .sentence = "0 is the time; a vector has three columns"};
constexpr Key timeStart{
    .name = "timeStart",
    .leftOut = "the start",
    .example = "10",
    .unit = unit::second,
    .sentence = "peaks before this time are ignored"};
constexpr Key timeEnd{
    .name = "timeEnd",
    .leftOut = "the end",
    .example = "20",
    .unit = unit::second,
    .sentence = "peaks after this time are ignored"};
constexpr Key threshold{
    .name = "threshold",
    .example = "500",
    .unit = ofSamples,
    .range = notNegative,
    .sentence = "peaks exceed this value"};
constexpr Key separation{
    .name = "separation",
    .example = "0.8",
    .unit = unit::second,
    .range = notNegative,
    .sentence = "of peaks closer than this only the largest is kept"};
constexpr Key windows{
    .name = "windows",
    .otherwise = "(0.001 0.005 0.01 0.02 0.04)",
    .unit = unit::second,
    .range = positive,
    .sentence =
        "lengths of averaging windows: for each peak the largest mean over a window that contains it (after the "
        "filter), one column of peaks.dat each; mean and standard deviation over the peaks in statistics.dat; () none"};
constexpr Key location{
    .name = "location",
    .leftOut = "threshold",
    .example = "500",
    .unit = ofSamples,
    .sentence = "location of the Weibull distribution, at most the threshold; 0: two-parameter Weibull"};
constexpr Key exceedance{
    .name = "exceedance",
    .leftOut = "none",
    .example = "(0.1 0.01)",
    .range = probability,
    .sentence = "exceedance probabilities, one or a list, of the estimated peak values"};
constexpr Key confidence{
    .name = "confidence",
    .otherwise = "0.95",
    .range = probability,
    .sentence = "confidence level of the bounds of the fit"};

constexpr Key left{
    .name = "left",
    .entries =
        []
    {
        return Keys{comparison::samples, column,     timeStart, timeEnd,  withExample(comparison::filter, "0.002"),
                    threshold,           separation, windows,   location, exceedance,
                    confidence};
    },
    .anyName = true};
constexpr Key right{
    .name = "right",
    .example = "$left;",
    .sentence = "as left, except the column",
    .entries = [] { return Keys{{.name = "column", .example = "2"}}; },
    .anyName = true};

} // namespace peakStatisticsDict

PeakQuery readPeakQuery(const Dictionary& dict)
{
    using namespace peakStatisticsDict;
    PeakQuery query;
    query.samples = dict.word(comparison::samples);
    query.column = static_cast<int>(dict.label(column));
    query.timeStart = dict.scalarOr(timeStart, query.timeStart);
    query.timeEnd = dict.scalarOr(timeEnd, query.timeEnd);
    if (query.timeEnd <= query.timeStart)
    {
        throw dict.errorAt(timeEnd, "is not after timeStart");
    }
    query.filter = dict.scalar(comparison::filter);
    query.threshold = dict.scalar(threshold);
    query.separation = dict.scalar(separation);
    query.windows = dict.scalars(windows);
    // Every peak is above the threshold, hence above the location.
    const Range belowPeaks{anyNumber.low, query.threshold};
    query.location = dict.scalarOr(location, query.threshold, location.unit, belowPeaks);
    if (dict.has(exceedance))
    {
        query.exceedance =
            dict.tokens(exceedance).size() == 1 ? std::vector{dict.scalar(exceedance)} : dict.scalars(exceedance);
        if (query.exceedance.empty())
        {
            throw dict.errorAt(exceedance, "is empty; expected probabilities");
        }
    }
    query.confidence = dict.scalar(confidence);
    dict.refuseUnknown(left.entries());
    return query;
}

} // namespace

Keys peakStatisticsDictKeys()
{
    return {peakStatisticsDict::left, peakStatisticsDict::right};
}

std::vector<PeakQuery> readPeakQueries(const Dictionary& dict)
{
    std::vector<PeakQuery> queries;
    for (const auto& name : dict.keys())
    {
        if (name.front() == '.' || name.find('/') != std::string::npos)
        {
            throw dict.errorAt(name, "is not valid as the name of a folder");
        }
        queries.push_back(readPeakQuery(dict.dict(name)));
        queries.back().name = name;
        queries.back().place = dict.placeOf(name);
    }
    if (queries.empty())
    {
        throw CaseError(
            dict.name() + ": no entry found; expected <name> { samples ...; threshold ...; ... }",
            CaseError::Kind::input
        );
    }
    return queries;
}

} // namespace slosh
