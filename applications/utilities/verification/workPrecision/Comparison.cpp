// SPDX-License-Identifier: GPL-3.0-or-later
#include "Comparison.hpp"

#include <cmath>
#include <iomanip>
#include <map>
#include <sstream>

namespace slosh
{

namespace
{

/// The samples of the other run, treated as those of this one.
std::string sameSamples(const Dictionary& dict)
{
    std::string entries;
    for (const std::string key : {"samples", "column", "scale", "offset", "filter"})
    {
        if (dict.has(key))
        {
            for (const Token& token : dict.tokens(key))
            {
                entries += key + " " + token.text + "; ";
            }
        }
    }
    return entries;
}

} // namespace

std::string Comparison::text(const std::string& referenceRun) const
{
    // A bound is for who runs compareSamples by itself: here an error is a result, not a failure.
    std::string all = name + "\n{\n" + entries + "    #remove bound\n";
    if (reference == Reference::richardson)
    {
        all += "    #remove reference\n    reference { type none; }\n";
    }
    else if (needsRun())
    {
        all += "    #remove reference\n    reference { type samples; case \"" + referenceRun + "\"; " +
               sameSamples(Dictionary::parse(entries, name)) + "}\n";
    }
    return all + "}\n";
}

Comparison readComparison(const Dictionary& dict, const std::string& name)
{
    static const std::map<std::string, Comparison::Reference> types = {
        {"finest", Comparison::Reference::finest},
        {"run", Comparison::Reference::run},
        {"richardson", Comparison::Reference::richardson}};
    Comparison comparison;
    comparison.name = name;
    comparison.description = dict.wordOr("description", name);
    comparison.entries = dict.text();
    const Dictionary reference = dict.dict("reference");
    const std::string type = reference.word("type"), quantity = dict.word("quantity");
    comparison.source = reference.wordOr("source", type);
    comparison.isSeries = quantity == "difference";
    comparison.isShare = quantity != "timeOfMaximum" && quantity != "firstTimeAbove" && !dict.flagOr("ratio", false) &&
                         !(type == "stated" && reference.has("range"));
    if (const auto found = types.find(type); found != types.end())
    {
        comparison.reference = found->second;
        if (comparison.reference == Comparison::Reference::run)
        {
            comparison.run = reference.word("run");
            comparison.source = "run " + comparison.run;
        }
        reference.refuseUnknown();
    }
    if (comparison.reference == Comparison::Reference::richardson && comparison.isSeries)
    {
        throw reference.errorAt(
            "type", "is richardson, which extrapolates a figure; '" + quantity + "' is none: take the reference finest,"
        );
    }
    return comparison;
}

std::string errorText(const Comparison& comparison, double error)
{
    std::ostringstream text;
    text << std::setprecision(3);
    if (comparison.isShare)
    {
        text << 100 * error << " %";
    }
    else
    {
        text << error;
    }
    return text.str();
}

} // namespace slosh
