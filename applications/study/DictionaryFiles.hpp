// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace slosh
{

/// What decides a run: the files below constant and system of a case, named relative to it, with their bytes. Left out
/// is what programs write there (polyMesh, fvSchemes, fvSolution) and what is read after a run only:
/// system/comparisons..., peakStatistics..., sweep..., workPrecision...
using DictionaryFiles = std::map<std::string, std::string>;

/// Those of the case at `root`; none where there is no such folder. Throws CaseError for a file that cannot be read.
DictionaryFiles readDictionaryFiles(const std::filesystem::path& root);

/// Text for the ends of dictionary files: "system/blockParticlesDict" -> "particleSpacing 0.02;". Later entries of a
/// dictionary replace earlier ones, sub-dictionaries are merged.
using Edits = std::map<std::string, std::string>;

/// `files` with the edits at their ends, which say that `program` set them.
DictionaryFiles withEdits(DictionaryFiles files, const Edits& edits, const std::string& program);

} // namespace slosh
