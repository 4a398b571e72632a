// SPDX-License-Identifier: GPL-3.0-or-later
#include "Study.hpp"

#include <algorithm>
#include <functional>

namespace slosh
{

namespace
{

namespace workPrecisionDict
{

constexpr Key particleSpacing{
    .name = "particleSpacing",
    .sentence = "the spacing of blockParticlesDict: errors are fitted and extrapolated over this axis",
    .entries =
        []
    {
        Key range = withExample(axisEntries::range, "(0.0103 0.0155)"), count = withExample(axisEntries::count, "3"),
            direction = axisEntries::direction;
        range.alternative = count.alternative = direction.alternative = true;
        return Keys{
            withExample(axisEntries::file, "\"system/blockParticlesDict\""),
            withExample(axisEntries::entry, "particleSpacing"),
            withExample(axisEntries::values, "(0.0155 0.0129 0.0103)"),
            range,
            count,
            direction};
    },
    .anyName = true};
constexpr Key plain{
    .name = "plain",
    .example = R"("system/sphSchemes" { densityReinitialisation { type none; } })",
    .entries = noKeys,
    .anyName = true};
constexpr Key density{
    .name = "density",
    .entries =
        []
    {
        Key settings = axisEntries::settings;
        settings.entries = [] { return Keys{plain, axisEntries::mls}; };
        return Keys{settings};
    },
    .anyName = true};
constexpr Key axes{
    .name = "axes", .sentence = "any number, each with its own name; the last one varies fastest", .entries = [] {
        return Keys{particleSpacing, density};
    }};

constexpr Key threads{
    .name = "threads", .otherwise = "1", .range = between(1, 1024), .sentence = "threads of the solver"};

constexpr Key outside{
    .name = "outside",
    .leftOut = "none",
    .sentence =
        "completed runs of other programs: included in the tables and the diagram, compared with the same references",
    .entries = [] { return Keys{outsideRunKey()}; },
    .alternative = true};

constexpr Key comparisons{
    .name = "comparisons",
    .sentence = "entries as in comparisonsDict, each a table and a panel of the diagram; bound is ignored; the error "
                "is the |error| of compareSamples",
    .entries = [] { return Keys{comparisonKey()}; }};

constexpr Key targets{
    .name = "targets",
    .otherwise = "(0.05 0.02 0.01)",
    .range = positive,
    .sentence = "errors whose cost is estimated, relative (or in the unit of the figure)"};
constexpr Key formalOrder{
    .name = "formalOrder",
    .otherwise = "2",
    .range = between(1, 4),
    .sentence = "order of the scheme: the fit of a figure over at least four spacings accepts orders from 0.5 to this"};
constexpr Key ensemble{
    .name = "ensemble",
    .leftOut = "none",
    .example = "(density)",
    .sentence = "axes whose values are the members of an ensemble, e.g. amplitudes that differ by a thousandth; the "
                "mean over the members is the figure of a spacing, their scatter a part of its uncertainty",
    .alternative = true};

} // namespace workPrecisionDict

std::vector<Axis> readAxes(const Dictionary& dict, const DictionaryFiles& files)
{
    std::vector<Axis> axes;
    for (const auto& name : dict.keys())
    {
        axes.push_back(readAxis(dict.dict(name), name, files));
    }
    return axes;
}

/// Marks the axes that `ensemble` names.
void readEnsemble(const Dictionary& dict, std::vector<Axis>& axes)
{
    if (!dict.has(workPrecisionDict::ensemble))
    {
        return;
    }
    std::vector<std::string> names;
    names.reserve(axes.size());
    for (const Axis& axis : axes)
    {
        names.push_back(axis.name);
    }
    for (const auto& name : dict.words(workPrecisionDict::ensemble))
    {
        const auto found = std::find_if(axes.begin(), axes.end(), [&](const Axis& axis) { return axis.name == name; });
        if (found == axes.end())
        {
            throw unknownName("axis", name, dict.placeOf(workPrecisionDict::ensemble), names);
        }
        if (found->isSpacing)
        {
            throw dict.errorAt(
                workPrecisionDict::ensemble,
                "is " + name + ", the spacing; expected other axes, as the error is fitted over the spacing"
            );
        }
        found->isMember = true;
    }
}

std::vector<Comparison> readComparisons(const Dictionary& dict, const std::vector<Setting>& settings)
{
    std::vector<std::string> runs;
    runs.reserve(settings.size());
    for (const auto& setting : settings)
    {
        runs.push_back(setting.name);
    }
    std::vector<Comparison> comparisons;
    for (const auto& name : dict.keys())
    {
        comparisons.push_back(readComparison(dict.dict(name), name));
        const std::string& run = comparisons.back().run;
        if (!run.empty() && std::find(runs.begin(), runs.end(), run) == runs.end())
        {
            throw unknownName("run", run, dict.placeOf(name + "/reference/run"), runs);
        }
    }
    return comparisons;
}

} // namespace

Keys workPrecisionDictKeys()
{
    return {
        workPrecisionDict::axes,
        withExample(settingEntries::vary, "oneAtATime"),
        withExample(settingEntries::base, "particleSpacing 0.0129;"),
        workPrecisionDict::ensemble,
        workPrecisionDict::threads,
        workPrecisionDict::outside,
        workPrecisionDict::comparisons,
        workPrecisionDict::targets,
        workPrecisionDict::formalOrder};
}

Study Study::read(const Dictionary& dict, const DictionaryFiles& files)
{
    Study study;
    study.threads = dict.label(workPrecisionDict::threads);
    study.formalOrder = dict.scalar(workPrecisionDict::formalOrder);
    study.targets = dict.scalars(workPrecisionDict::targets);
    std::sort(study.targets.begin(), study.targets.end(), std::greater<>());
    study.axes = readAxes(dict.dict(workPrecisionDict::axes), files);
    if (study.axes.empty())
    {
        throw dict.errorAt(workPrecisionDict::axes, "is empty; expected at least one entry to vary");
    }
    study.axesPlace = dict.placeOf(workPrecisionDict::axes);
    study.comparisonsPlace = dict.placeOf(workPrecisionDict::comparisons);
    readEnsemble(dict, study.axes);
    study.settings = readSettings(dict, study.axes);
    std::stable_sort(
        study.settings.begin(), study.settings.end(),
        [](const Setting& a, const Setting& b) { return a.wantedSpacing > b.wantedSpacing; }
    );
    study.outside = readOutsideRuns(dict.dictOr(workPrecisionDict::outside));
    const Dictionary comparisons = dict.dict(workPrecisionDict::comparisons);
    dict.refuseUnknown(workPrecisionDictKeys());
    study.comparisons = readComparisons(comparisons, study.settings);
    if (study.comparisons.empty())
    {
        throw dict.errorAt(workPrecisionDict::comparisons, "is empty; expected at least one comparison");
    }
    return study;
}

} // namespace slosh
