// SPDX-License-Identifier: GPL-3.0-or-later
#include "Comparison.hpp"

#include "statistics/comparisonKeys.hpp"

#include <cmath>
#include <iomanip>
#include <map>
#include <sstream>

namespace slosh
{

namespace
{

namespace comparisons
{

constexpr Key run{.name = "run", .example = "particleSpacing=0.0103_density=plain", .sentence = "name of the run"};
constexpr Key type{
    .name = "type",
    .example = "finest",
    .sentence = "or a type of comparisonsDict",
    .options = []
    {
        return Options{
            {"finest", "the run with the smallest spacing and the same values of the other axes"},
            {"run", "a run of the table, the same for all", [] { return Keys{run}; }},
            {"richardson",
             "the figure extrapolated to spacing 0 by a least-squares fit to all spacings, at least four"}};
    }};
constexpr Key source{
    .name = "source",
    .leftOut = "the type, with the name of a run",
    .example = "\"a finer run\"",
    .sentence = "name in the summary",
    .alternative = true};
constexpr Key reference{.name = "reference", .entries = [] { return Keys{type, source}; }};

constexpr Key quantity{.name = "quantity", .example = "maximum"};
constexpr Key peak{
    .name = "peak",
    .entries =
        []
    {
        return Keys{
            withExample(comparison::description, "\"highest pressure\""),
            comparison::samples,
            comparison::column,
            comparison::unit,
            quantity,
            reference};
    },
    .anyName = true};

} // namespace comparisons

/// The samples of the other run, treated as those of this one.
std::string sameSamples(const Dictionary& dict)
{
    std::string entries;
    for (const Key& key :
         {comparison::samples, comparison::column, comparison::scale, comparison::offset, comparison::filter})
    {
        if (dict.has(key))
        {
            for (const Token& token : dict.tokens(key))
            {
                entries += std::string(key.name) + " " + token.text + "; ";
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

Key comparisonKey()
{
    return comparisons::peak;
}

Comparison readComparison(const Dictionary& dict, const std::string& name)
{
    static const std::map<std::string, Comparison::Reference> types = {
        {"finest", Comparison::Reference::finest},
        {"run", Comparison::Reference::run},
        {"richardson", Comparison::Reference::richardson}};
    Comparison comparison;
    comparison.name = name;
    comparison.description = dict.wordOr(comparison::description, name);
    comparison.entries = dict.text();
    comparison.unit = dict.wordOr(comparison::unit, "");
    const Dictionary reference = dict.dict(comparisons::reference);
    const std::string type = reference.word(comparisons::type), quantity = dict.word(comparisons::quantity);
    comparison.source = reference.wordOr(comparisons::source, type);
    comparison.isSeries = quantity == "difference";
    comparison.isShare = quantity != "timeOfMaximum" && quantity != "firstTimeAbove" && !dict.flag(comparison::ratio) &&
                         !(type == "stated" && reference.has("range"));
    if (const auto found = types.find(type); found != types.end())
    {
        comparison.reference = found->second;
        if (comparison.reference == Comparison::Reference::run)
        {
            comparison.run = reference.word(comparisons::run);
            comparison.source = reference.wordOr(comparisons::source, "run " + comparison.run);
        }
        reference.refuseIdle(comparisons::reference.entries());
    }
    if (comparison.reference == Comparison::Reference::richardson && comparison.isSeries)
    {
        throw reference.errorAt(
            comparisons::type, "is richardson, which extrapolates a single figure; expected finest for " + quantity
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
