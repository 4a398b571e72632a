// SPDX-License-Identifier: GPL-3.0-or-later
#include "PeakQuery.hpp"

namespace slosh
{

namespace
{

constexpr Unit ofSamples{{}, "the unit of the samples"};
constexpr Range probability{0, 1, false, false};

PeakQuery readPeakQuery(const Dictionary& dict)
{
    PeakQuery query;
    query.samples = dict.word("samples");
    query.column = static_cast<int>(dict.labelOr("column", query.column, between(1, 1e6)));
    query.timeStart = dict.scalarOr("timeStart", query.timeStart, unit::second);
    query.timeEnd = dict.scalarOr("timeEnd", query.timeEnd, unit::second);
    if (query.timeEnd <= query.timeStart)
    {
        throw dict.errorAt("timeEnd", "is not after timeStart");
    }
    query.filter = dict.scalarOr("filter", query.filter, unit::second, notNegative);
    query.threshold = dict.scalar("threshold", ofSamples, notNegative);
    query.separation = dict.scalar("separation", unit::second, notNegative);
    if (dict.has("windows"))
    {
        query.windows = dict.scalars("windows", unit::second, positive);
    }
    // Every peak is above the threshold, hence above the location.
    const Range belowPeaks{anyNumber.low, query.threshold};
    query.location = dict.scalarOr("location", query.threshold, ofSamples, belowPeaks);
    if (dict.has("exceedance"))
    {
        query.exceedance = dict.tokens("exceedance").size() == 1
                               ? std::vector{dict.scalar("exceedance", unit::none, probability)}
                               : dict.scalars("exceedance", unit::none, probability);
        if (query.exceedance.empty())
        {
            throw dict.errorAt("exceedance", "holds no probability");
        }
    }
    query.confidence = dict.scalarOr("confidence", query.confidence, unit::none, probability);
    dict.refuseUnknown();
    return query;
}

} // namespace

std::vector<PeakQuery> readPeakQueries(const Dictionary& dict)
{
    std::vector<PeakQuery> queries;
    for (const auto& name : dict.keys())
    {
        if (name.front() == '.' || name.find('/') != std::string::npos)
        {
            throw dict.errorAt(name, "cannot name a folder of results");
        }
        queries.push_back(readPeakQuery(dict.dict(name)));
        queries.back().name = name;
        queries.back().place = dict.placeOf(name);
    }
    if (queries.empty())
    {
        throw CaseError(
            dict.name() + " names no samples: add an entry <name> { samples ...; threshold ...; ... }",
            CaseError::Kind::input
        );
    }
    return queries;
}

} // namespace slosh
