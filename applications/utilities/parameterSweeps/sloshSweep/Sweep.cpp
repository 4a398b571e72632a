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

SweepAxis readSweepAxis(const Dictionary& dict, const std::string& name, const DictionaryFiles& files)
{
    SweepAxis axis;
    axis.unit = dict.wordOr("unit", "");
    axis.naturalMode = dict.labelOr("naturalFrequency", 0, between(1, 20));
    static_cast<Axis&>(axis) = readAxis(dict, name, files);
    const auto last = axis.entry.rfind('.');
    axis.isFrequency = axis.naturalMode > 0 || axis.entry.substr(last == std::string::npos ? 0 : last + 1) == "omega";
    if (axis.naturalMode == 0)
    {
        return axis;
    }
    if (axis.file.empty() || axis.direction)
    {
        throw dict.errorAt("naturalFrequency", "is for an axis whose values are numbers of one entry,");
    }
    for (auto& value : axis.values)
    {
        double multiple = 0;
        if (!isNumber(value.label, multiple) || !(multiple > 0))
        {
            throw dict.errorAt(
                dict.has("range") ? "range" : "values",
                "holds '" + value.label + "', no number > 0 to multiply a natural frequency with,"
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
    if (dict.has("ensemble"))
    {
        if (const auto& tokens = dict.tokens("ensemble"); !tokens.empty() && tokens.front().is('('))
        {
            wanted = dict.words("ensemble");
            if (wanted.empty())
            {
                throw dict.errorAt("ensemble", "names no axis");
            }
        }
        else if (dict.flag("ensemble"))
        {
            wanted = names;
        }
    }
    std::vector<std::size_t> members;
    for (const auto& name : wanted)
    {
        const auto found = std::find(names.begin(), names.end(), name);
        if (found == names.end())
        {
            throw unknownName("axis", name, dict.placeOf("ensemble"), names);
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
            throw CaseError("natural frequencies are those of liquid that reaches from wall to wall, under gravity");
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

Sweep Sweep::read(const Dictionary& dict, const DictionaryFiles& files, const std::filesystem::path& runs)
{
    Sweep sweep;
    sweep.axes = readAxes(dict.dict("axes"), files);
    if (sweep.axes.empty())
    {
        throw dict.errorAt("axes", "is empty: there is nothing to vary");
    }
    sweep.memberAxes = readMemberAxes(dict, sweep.axes);
    const std::vector<Setting> settings = readSettings(dict, std::vector<Axis>(sweep.axes.begin(), sweep.axes.end()));
    const Dictionary slurm = dict.dictOr("slurm");
    sweep.slurmThreads = slurm.labelOr("threads", 1, between(1, 1024));
    if (slurm.has("options"))
    {
        sweep.slurmOptions = slurm.words("options");
    }
    slurm.refuseUnknown();
    const Dictionary results = dict.dictOr("results");
    dict.refuseUnknown();
    for (const auto& name : results.keys())
    {
        sweep.results.push_back(readResult(results.dict(name), name));
    }
    if (!sweep.memberAxes.empty() && sweep.results.empty())
    {
        throw dict.errorAt("ensemble", "is set without 'results' to take the means of,");
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
