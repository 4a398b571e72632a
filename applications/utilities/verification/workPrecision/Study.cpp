// SPDX-License-Identifier: GPL-3.0-or-later
#include "Study.hpp"

#include <algorithm>
#include <functional>

namespace slosh
{

namespace
{

std::vector<Axis> readAxes(const Dictionary& dict, const DictionaryFiles& files)
{
    std::vector<Axis> axes;
    for (const auto& name : dict.keys())
    {
        axes.push_back(readAxis(dict.dict(name), name, files));
    }
    return axes;
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
            throw unknownName("run", run, dict.dict(name).dict("reference").placeOf("run"), runs);
        }
    }
    return comparisons;
}

} // namespace

Study Study::read(const Dictionary& dict, const DictionaryFiles& files)
{
    Study study;
    study.threads = dict.labelOr("threads", 1, between(1, 1024));
    study.formalOrder = dict.scalarOr("formalOrder", 1, unit::none, positive);
    study.targets =
        dict.has("targets") ? dict.scalars("targets", unit::none, positive) : std::vector<double>{0.05, 0.02, 0.01};
    std::sort(study.targets.begin(), study.targets.end(), std::greater<>());
    study.axes = readAxes(dict.dict("axes"), files);
    if (study.axes.empty())
    {
        throw dict.errorAt("axes", "is empty: there is nothing to vary");
    }
    study.settings = readSettings(dict, study.axes);
    std::stable_sort(
        study.settings.begin(), study.settings.end(),
        [](const Setting& a, const Setting& b) { return a.wantedSpacing > b.wantedSpacing; }
    );
    study.outside = readOutsideRuns(dict.dictOr("outside"));
    const Dictionary comparisons = dict.dict("comparisons");
    dict.refuseUnknown();
    study.comparisons = readComparisons(comparisons, study.settings);
    if (study.comparisons.empty())
    {
        throw dict.errorAt("comparisons", "is empty: there is no error to measure");
    }
    return study;
}

} // namespace slosh
