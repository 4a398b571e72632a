// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Run.hpp"

namespace slosh
{

/// A run of another program, made by somebody else, that is held against the same reference as ours: a folder with
/// postProcessing/<function>/<start time>/<file>, as our functions write them, and a file `cost` as in Outcome.
struct OutsideRun
{
    std::string program; ///< its scheme in tables
    std::string name;    ///< of the run: "interFoam_40"
    std::filesystem::path folder;
};

/// An entry of the dictionary `outside`.
Key outsideRunKey();

/// Reads the dictionary `outside`. Throws CaseError where two runs would have one name.
std::vector<OutsideRun> readOutsideRuns(const Dictionary& dict);

/// Puts the samples and the cost of a run into `run.folder`, with the dictionaries of the case: what compareSamples
/// needs. False where `root`/folder has no cost: nobody has made that run.
bool takeOutsideRun(
    const OutsideRun& outside, const std::filesystem::path& root, const DictionaryFiles& files, Run& run
);

} // namespace slosh
