// SPDX-License-Identifier: GPL-3.0-or-later
#include "Reference.hpp"

#include "exactSeries.hpp"

#include "statistics/movingAverage.hpp"

#include <cmath>
#include <cstdlib>
#include <functional>
#include <limits>
#include <map>

namespace slosh
{

namespace
{

namespace fs = std::filesystem;

Reference stated(const Dictionary& dict)
{
    Reference reference;
    if (dict.has("range"))
    {
        const auto ends = dict.scalars("range", unit::none);
        if (ends.size() != 2 || !(ends[0] < ends[1]))
        {
            throw dict.errorAt("range", "must hold two values, (from to), the first the smaller,");
        }
        reference.range = {ends[0], ends[1]};
    }
    else
    {
        reference.figure = {
            dict.scalar("value", unit::none),
            dict.scalarOr("uncertainty", std::numeric_limits<double>::quiet_NaN(), unit::none, notNegative)};
    }
    return reference;
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

Reference measured(const Dictionary& dict)
{
    const std::string name = dict.word("file");
    const char* folder = std::getenv("SLOSH_MEASURED");
    const int timeColumn = static_cast<int>(dict.labelOr("timeColumn", 0, notNegative));
    const double timeScale = dict.scalarOr("timeScale", 1, unit::none, positive);
    const double timeShift = dict.scalarOr("timeShift", 0, unit::second);
    const double scale = dict.scalarOr("scale", 1, unit::none);
    const double offset = dict.scalarOr("offset", 0, unit::none);
    const int column = static_cast<int>(dict.label("column", notNegative));
    const bool hasBand = dict.has("lowColumn") || dict.has("highColumn");
    const int low = hasBand ? static_cast<int>(dict.label("lowColumn", notNegative)) : 0;
    const int high = hasBand ? static_cast<int>(dict.label("highColumn", notNegative)) : 0;

    const fs::path file = folder != nullptr ? fs::path(folder) / name : fs::path();
    if (folder == nullptr || !fs::exists(file))
    {
        throw MissingRecord(
            name + (folder == nullptr ? ": the variable SLOSH_MEASURED names no folder of measurements"
                                      : " is not in " + std::string(folder) + " (SLOSH_MEASURED)")
        );
    }
    const auto read = [&](int k)
    { return scaled(readTimeSeries(file, k, timeColumn), timeScale, timeShift, scale, offset); };
    Reference reference;
    reference.series = read(column);
    if (hasBand)
    {
        reference.band = {read(low), read(high)};
    }
    return reference;
}

Reference samplesOf(const Dictionary& dict, const Case& theCase)
{
    const fs::path other = theCase.root() / dict.wordOr("case", ".");
    Reference reference;
    reference.series = scaled(
        readSamples(
            other / "postProcessing" / dict.word("samples"), static_cast<int>(dict.label("column", notNegative))
        ),
        1, 0, dict.scalarOr("scale", 1, unit::none), dict.scalarOr("offset", 0, unit::none)
    );
    reference.series = movingAverage(*reference.series, dict.scalarOr("filter", 0, unit::second, notNegative));
    reference.timeStart = dict.scalarOr("timeStart", reference.timeStart, unit::second);
    reference.timeEnd = dict.scalarOr("timeEnd", reference.timeEnd, unit::second);
    return reference;
}

} // namespace

Reference readReference(const Dictionary& dict, const Case& theCase, const TimeSeries& samples)
{
    const auto exact = [&](auto make)
    {
        Reference reference;
        reference.series = make();
        return reference;
    };
    const std::map<std::string, std::function<Reference()>> types = {
        {"none", [] { return Reference(); }},
        {"stated", [&] { return stated(dict); }},
        {"measured", [&] { return measured(dict); }},
        {"samples", [&] { return samplesOf(dict, theCase); }},
        {"linearSloshing", [&] { return exact([&] { return linearSloshing(dict, theCase, samples); }); }},
        {"nonlinearSloshing", [&] { return exact([&] { return nonlinearSloshing(dict, theCase, samples); }); }},
        {"viscousStandingWave", [&] { return exact([&] { return viscousStandingWave(dict, theCase, samples); }); }},
        {"stretchingPatch", [&] { return exact([&] { return stretchingPatch(dict, theCase, samples); }); }},
        {"stretchingDrop", [&] { return exact([&] { return stretchingDrop(dict, theCase, samples); }); }}};
    std::vector<std::string> valid;
    valid.reserve(types.size());
    for (const auto& type : types)
    {
        valid.push_back(type.first);
    }
    const std::string source = dict.wordOr("source", "");
    Reference reference = types.at(dict.choice("type", valid, "type of reference"))();
    reference.source = source;
    dict.refuseUnknown();
    return reference;
}

} // namespace slosh
