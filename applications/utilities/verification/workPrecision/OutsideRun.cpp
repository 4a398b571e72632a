// SPDX-License-Identifier: GPL-3.0-or-later
#include "OutsideRun.hpp"

#include "base/writeFile.hpp"

#include <algorithm>

namespace slosh
{

namespace fs = std::filesystem;

namespace
{

namespace outside
{

constexpr Key folders{
    .name = "folders",
    .example = "(\"interFoam/runs/40\" \"interFoam/runs/80\")",
    .sentence = "relative to the case. Each contains the samples of the comparisons, as written by SloshSPH "
                "(postProcessing/pressure/0/p), and a dictionary cost: cpuSeconds, spacing [m], particles (or cells), "
                "steps. A folder without cost is omitted"};
constexpr Key interFoam{.name = "interFoam", .entries = [] { return Keys{folders}; }, .anyName = true};

} // namespace outside

} // namespace

Key outsideRunKey()
{
    return outside::interFoam;
}

std::vector<OutsideRun> readOutsideRuns(const Dictionary& dict)
{
    std::vector<OutsideRun> runs;
    for (const auto& program : dict.keys())
    {
        const Dictionary entry = dict.dict(program);
        for (const auto& folder : entry.words(outside::folders))
        {
            const std::string name = program + "_" + fs::path(folder).filename().string();
            if (std::any_of(runs.begin(), runs.end(), [&](const OutsideRun& other) { return other.name == name; }))
            {
                throw entry.errorAt(outside::folders, "names two runs '" + name + "'");
            }
            runs.push_back({program, name, folder});
        }
        entry.refuseUnknown(outside::interFoam.entries());
    }
    return runs;
}

bool takeOutsideRun(const OutsideRun& outside, const fs::path& root, const DictionaryFiles& files, Run& run)
{
    const fs::path from = root / outside.folder;
    const auto outcome = readOutcome(from);
    if (!outcome)
    {
        return false;
    }
    fs::remove_all(run.folder);
    for (const auto& [file, content] : files)
    {
        writeFile(run.folder / file, content);
    }
    if (fs::is_directory(from / "postProcessing"))
    {
        fs::copy(from / "postProcessing", run.folder / "postProcessing", fs::copy_options::recursive);
    }
    run.outcome = *outcome;
    writeOutcome(run.folder, run.outcome);
    return true;
}

} // namespace slosh
