// SPDX-License-Identifier: GPL-3.0-or-later
#include "Sweep.hpp"

#include "base/numberText.hpp"
#include "dictionary/tokenize.hpp"

#include <algorithm>

namespace slosh
{

namespace
{

constexpr int modesShown = 3;

namespace sweepDict
{

constexpr Key unit{
    .name = "unit",
    .leftOut = "none",
    .example = "deg",
    .sentence = "unit of the values in table and map; \"rad/s\" in quotes"};
constexpr Key naturalFrequency{
    .name = "naturalFrequency",
    .leftOut = "none",
    .example = "1",
    .range = between(1, 20),
    .sentence = "n: the values are multiples of the n-th natural frequency (linear theory) of each case's own "
                "tank, depth and gravity; otherwise they are used as given"};

constexpr std::string_view motionFile = "\"constant/dynamicMeshDict\"";
constexpr Key frequency{
    .name = "frequency",
    .entries =
        []
    {
        return Keys{
            withExample(axisEntries::file, motionFile),
            withExample(axisEntries::entry, "oscillatingRotatingMotionCoeffs.omega"),
            withExample(axisEntries::range, "(0.9 1.1)"), withExample(axisEntries::count, "2"), naturalFrequency};
    },
    .anyName = true};
constexpr Key angle{
    .name = "angle",
    .entries =
        []
    {
        return Keys{
            {.name = axisEntries::file, .example = motionFile},
            {.name = axisEntries::entry, .example = "oscillatingRotatingMotionCoeffs.amplitude"},
            axisEntries::direction,
            withExample(axisEntries::values, "(4 8)"),
            unit};
    },
    .anyName = true};
constexpr Key density{
    .name = "density",
    .entries =
        []
    {
        Key settings = axisEntries::settings;
        settings.entries = [] { return Keys{axisEntries::mls}; };
        return Keys{settings};
    },
    .anyName = true};
constexpr Key axes{
    .name = "axes", .sentence = "any number, each with its own name; the last one varies fastest", .entries = [] {
        return Keys{frequency, angle, density};
    }};

constexpr Key ensemble{
    .name = "ensemble",
    .otherwise = "no",
    .example = "(density)",
    .sentence = "axes whose values are the members of an ensemble, e.g. amplitudes that differ by a thousandth (not "
                "the spacing, as whole cells fit the tank); yes: all axes. For each result and each combination of the "
                "other axes, ensemble.tsv then has mean, standard deviation and standard error over the members, and "
                "the reference with its uncertainty",
    .alternative = true};

constexpr Key results{
    .name = "results",
    .leftOut = "none",
    .sentence = "entries as in comparisonsDict, each a column of the table and a panel of the map; a reference adds a "
                "column and a dashed curve",
    .entries = [] { return Keys{resultKey()}; }};

constexpr Key threads{
    .name = "threads", .otherwise = "1", .range = between(1, 1024), .sentence = "threads of each case"};
constexpr Key options{
    .name = "options",
    .leftOut = "none",
    .example = "(\"--time=4:00:00\" \"--partition=long\")",
    .sentence = "options of sbatch",
    .alternative = true};
constexpr Key slurm{.name = "slurm", .sentence = "for sloshSweep -slurm, which writes sweep.sbatch", .entries = [] {
                        return Keys{threads, options};
                    }};

} // namespace sweepDict

SweepAxis readSweepAxis(const Dictionary& dict, const std::string& name, const DictionaryFiles& files)
{
    SweepAxis axis;
    axis.unit = dict.wordOr(sweepDict::unit, "");
    axis.naturalMode = dict.labelOr(sweepDict::naturalFrequency, 0);
    static_cast<Axis&>(axis) = readAxis(dict, name, files);
    const auto last = axis.entry.rfind('.');
    axis.isFrequency = axis.naturalMode > 0 || axis.entry.substr(last == std::string::npos ? 0 : last + 1) == "omega";
    if (axis.naturalMode == 0)
    {
        return axis;
    }
    if (axis.file.empty() || axis.direction)
    {
        throw dict.errorAt(sweepDict::naturalFrequency, "is for an axis whose values are numbers of one entry");
    }
    for (auto& value : axis.values)
    {
        double multiple = 0;
        if (!isNumber(value.label, multiple) || !(multiple > 0))
        {
            throw dict.errorAt(
                dict.has(axisEntries::range) ? axisEntries::range : axisEntries::values,
                "has '" + value.label + "'; expected numbers > 0, factors of the natural frequency"
            );
        }
        value.edits.clear(); // they follow from the other axes
    }
    return axis;
}

std::vector<SweepAxis> readAxes(const Dictionary& dict, const DictionaryFiles& files)
{
    std::vector<SweepAxis> axes;
    for (const auto& name : dict.keys())
    {
        axes.push_back(readSweepAxis(dict.dict(name), name, files));
    }
    return axes;
}

/// ensemble yes: all; ensemble (a b): those two.
std::vector<std::size_t> readMemberAxes(const Dictionary& dict, const std::vector<SweepAxis>& axes)
{
    std::vector<std::string> names;
    names.reserve(axes.size());
    for (const auto& axis : axes)
    {
        names.push_back(axis.name);
    }
    std::vector<std::string> wanted;
    const auto tokens = dict.has(sweepDict::ensemble) ? dict.tokens(sweepDict::ensemble) : std::vector<Token>();
    if (!tokens.empty() && tokens.front().is('('))
    {
        wanted = dict.words(sweepDict::ensemble);
        if (wanted.empty())
        {
            throw dict.errorAt(sweepDict::ensemble, "is empty; expected the name of an axis");
        }
    }
    else if (dict.flag(sweepDict::ensemble))
    {
        wanted = names;
    }
    std::vector<std::size_t> members;
    for (const auto& name : wanted)
    {
        const auto found = std::find(names.begin(), names.end(), name);
        if (found == names.end())
        {
            throw unknownName("axis", name, dict.placeOf(sweepDict::ensemble), names);
        }
        members.push_back(static_cast<std::size_t>(found - names.begin()));
    }
    return members;
}

void append(Edits& to, const Edits& edits)
{
    for (const auto& [file, entries] : edits)
    {
        to[file] += entries + "\n";
    }
}

/// All of the case, its natural frequencies put in where they are multiplied.
SweptCase caseOf(const Setting& setting, const Sweep& sweep, const DictionaryFiles& files)
{
    SweptCase one;
    one.setting = setting;
    long modes = modesShown;
    for (const auto& axis : sweep.axes)
    {
        modes = std::max(modes, axis.naturalMode);
    }
    // A case that was stopped goes on, whatever the base says.
    append(one.setting.edits, {{"system/controlDict", "startFrom latestTime;"}});
    one.files = withEdits(files, one.setting.edits, "sloshSweep");
    one.facts = caseFacts(one.files, static_cast<int>(modes));
    bool isMultiple = false;
    for (std::size_t k = 0; k < sweep.axes.size(); ++k)
    {
        const SweepAxis& axis = sweep.axes[k];
        if (axis.naturalMode == 0)
        {
            continue;
        }
        if (one.facts.naturalFrequencies.empty())
        {
            throw CaseError("natural frequencies need liquid that extends from wall to wall, under gravity");
        }
        isMultiple = true;
        double multiple = 1;
        isNumber(axis.values[setting.values[k]].label, multiple);
        const double omega = multiple * one.facts.naturalFrequencies[axis.naturalMode - 1];
        append(one.setting.edits, axis.editsFor(numberText(omega)));
    }
    if (isMultiple)
    {
        one.files = withEdits(files, one.setting.edits, "sloshSweep");
        one.facts = caseFacts(one.files, static_cast<int>(modes));
    }
    for (const Result& result : sweep.results)
    {
        result.text(one.facts); // what it cannot be made of is told now
    }
    return one;
}

} // namespace

std::string SweepAxis::title() const
{
    const std::string of = naturalMode > 0 ? "omega/omega" + std::to_string(naturalMode) : unit;
    return of.empty() ? name : name + " [" + of + "]";
}

Keys sweepDictKeys()
{
    Key base = withExample(settingEntries::base, "angle 8;");
    base.alternative = true;
    return {sweepDict::axes, settingEntries::vary, base, sweepDict::ensemble, sweepDict::results, sweepDict::slurm};
}

Sweep Sweep::read(const Dictionary& dict, const DictionaryFiles& files, const std::filesystem::path& runs)
{
    Sweep sweep;
    sweep.axes = readAxes(dict.dict(sweepDict::axes), files);
    if (sweep.axes.empty())
    {
        throw dict.errorAt(sweepDict::axes, "is empty; expected at least one entry to vary");
    }
    sweep.memberAxes = readMemberAxes(dict, sweep.axes);
    const std::vector<Setting> settings = readSettings(dict, std::vector<Axis>(sweep.axes.begin(), sweep.axes.end()));
    const Dictionary slurm = dict.dictOr(sweepDict::slurm);
    sweep.slurmThreads = slurm.label(sweepDict::threads);
    if (slurm.has(sweepDict::options))
    {
        sweep.slurmOptions = slurm.words(sweepDict::options);
    }
    slurm.refuseUnknown(sweepDict::slurm.entries());
    const Dictionary results = dict.dictOr(sweepDict::results);
    dict.refuseUnknown(sweepDictKeys());
    for (const auto& name : results.keys())
    {
        sweep.results.push_back(readResult(results.dict(name), name));
    }
    if (!sweep.memberAxes.empty() && sweep.results.empty())
    {
        throw dict.errorAt(sweepDict::ensemble, "is set without results; expected results to average");
    }
    for (const auto& setting : settings)
    {
        try
        {
            sweep.cases.push_back(caseOf(setting, sweep, files));
        }
        catch (const CaseError& error)
        {
            throw CaseError(
                std::string(error.what()) + "\n(the case " + setting.name + " of " + dict.name() + ")", error.kind()
            );
        }
        SweptCase& one = sweep.cases.back();
        one.number = std::ssize(sweep.cases);
        one.folder = runs / setting.name;
    }
    return sweep;
}

} // namespace slosh
