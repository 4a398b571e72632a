// SPDX-License-Identifier: GPL-3.0-or-later
#include "Result.hpp"

#include "base/numberText.hpp"
#include "statistics/Quantity.hpp"

#include <numbers>

namespace slosh
{

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
                "the result '" + name + "' wants the last " + numberText(lastPeriods) + " periods of " +
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
    result.description = dict.wordOr("description", name);
    result.unit = dict.wordOr("unit", "");
    result.entries = dict.text();
    if (dict.has("reference"))
    {
        const Dictionary reference = dict.dict("reference");
        const std::string type = reference.word("type");
        result.hasReference = type != "none";
        result.reference = reference.wordOr("source", type);
    }
    const std::string quantity = dict.word("quantity");
    result.hasUncertainty = quantity == "meanPeak";
    const bool ofTwoSeries = quantity == "difference" || quantity == "shareInside";
    if (ofTwoSeries && !result.hasReference)
    {
        throw dict.errorAt("quantity", "is " + quantity + ", which needs a reference,");
    }
    if (quantity == "meanPeak" && !dict.has("period"))
    {
        result.lacksPeriod = true;
    }
    else if (!ofTwoSeries)
    {
        readQuantity(dict);
    }
    if (dict.has("lastPeriods"))
    {
        result.lastPeriods = dict.scalar("lastPeriods", unit::none, positive);
        if (dict.has("timeStart"))
        {
            throw dict.errorAt("timeStart", "is set besides 'lastPeriods': give one of them,");
        }
    }
    result.needsPeriod = result.lastPeriods > 0 || result.lacksPeriod;
    dict.word("samples");
    dict.label("column", notNegative);
    dict.allow({"scale", "offset", "filter", "timeStart", "timeEnd", "ratio", "stated", "bound"});
    allowEntriesOfQuantities(dict);
    dict.refuseUnknown();
    return result;
}

std::string withUnit(const std::string& value, const std::string& unit)
{
    return unit.empty() ? value : value + " " + unit;
}

} // namespace slosh
