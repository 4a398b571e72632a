// SPDX-License-Identifier: GPL-3.0-or-later
#include "Result.hpp"

#include "base/numberText.hpp"
#include "statistics/comparisonKeys.hpp"

#include <numbers>

namespace slosh
{

namespace
{

namespace results
{

constexpr Key quantity{.name = "quantity", .example = "meanPeak"};
constexpr Key period{
    .name = "period",
    .leftOut = "that of the tank's harmonic motion",
    .example = "0.01",
    .unit = unit::second,
    .range = positive,
    .sentence = "period of meanPeak"};
constexpr Key lastPeriods{
    .name = "lastPeriods",
    .example = "5",
    .range = positive,
    .sentence = "instead of timeStart: number of periods of the tank's motion before endTime",
    .alternative = true};

constexpr Key type{.name = "type", .example = "linearSloshing"};
constexpr Key source{
    .name = "source", .leftOut = "the type", .example = "\"linear theory\"", .sentence = "name in map and tables"};
constexpr Key reference{
    .name = "reference",
    .leftOut = "none",
    .entries =
        [] {
            return Keys{type, source};
        },
    .alternative = true};

constexpr Key peak{
    .name = "peak",
    .entries =
        []
    {
        return Keys{
            comparison::description,
            comparison::samples,
            comparison::column,
            comparison::unit,
            quantity,
            period,
            lastPeriods,
            reference};
    },
    .anyName = true};

} // namespace results

} // namespace

Key resultKey()
{
    return results::peak;
}

std::string Result::text(const CaseFacts& facts) const
{
    std::string all = name + "\n{\n" + entries + "    #remove (bound lastPeriods)\n";
    if (needsPeriod && !facts.omega)
    {
        throw CaseError("the result '" + name + "' counts periods; the motion of the tank is not harmonic");
    }
    const double T = needsPeriod ? 2 * std::numbers::pi / *facts.omega : 0;
    if (lastPeriods > 0)
    {
        const double begin = facts.endTime - lastPeriods * T;
        if (begin < 0)
        {
            throw CaseError(
                "the result '" + name + "' needs the last " + numberText(lastPeriods) + " periods of " +
                numberText(T, 6) + " s; the run ends at " + numberText(facts.endTime) + " s"
            );
        }
        all += "    timeStart " + numberText(begin) + ";\n";
    }
    if (lacksPeriod)
    {
        all += "    period " + numberText(T) + ";\n";
    }
    if (!hasReference)
    {
        all += "    #remove reference\n    reference { type none; }\n";
    }
    return all + "}\n";
}

Result readResult(const Dictionary& dict, const std::string& name)
{
    Result result;
    result.name = name;
    result.description = dict.wordOr(comparison::description, name);
    result.unit = dict.wordOr(comparison::unit, "");
    result.entries = dict.text();
    if (dict.has(results::reference))
    {
        const Dictionary reference = dict.dict(results::reference);
        const std::string type = reference.word(results::type);
        result.hasReference = type != "none";
        result.reference = reference.wordOr(results::source, type);
    }
    const std::string quantity = dict.word(results::quantity);
    result.hasUncertainty = quantity == "meanPeak";
    const bool ofTwoSeries = quantity == "difference" || quantity == "shareInside";
    if (ofTwoSeries && !result.hasReference)
    {
        throw dict.errorAt(results::quantity, "is " + quantity + ", which needs a reference");
    }
    if (quantity == "meanPeak" && !dict.has(results::period))
    {
        result.lacksPeriod = true;
    }
    else if (!ofTwoSeries)
    {
        readQuantity(dict);
    }
    if (dict.has(results::lastPeriods))
    {
        result.lastPeriods = dict.scalar(results::lastPeriods);
        if (dict.has(comparison::timeStart))
        {
            throw dict.errorAt(comparison::timeStart, "and lastPeriods are both set; expected one of them");
        }
    }
    result.needsPeriod = result.lastPeriods > 0 || result.lacksPeriod;
    dict.word(comparison::samples);
    dict.label(comparison::column);
    dict.refuseUnknown(joined(results::peak.entries(), comparisonKeys()));
    return result;
}

std::string withUnit(const std::string& value, const std::string& unit)
{
    return unit.empty() ? value : value + " " + unit;
}

} // namespace slosh
