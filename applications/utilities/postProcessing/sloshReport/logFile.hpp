// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace slosh
{

/// What a log of sloshSPHFoam says of the run.
struct LogFile
{
    using Fact = std::pair<std::string, std::string>;

    std::string version;            ///< "0.1.0"
    std::string date;               ///< of the start: "Nov 26 2026 14:25:03"
    std::vector<std::string> words; ///< from "pair loop:" and "left out:" to the time loop, as they stand
    std::vector<std::string> warnings;
    std::vector<Fact> facts;                    ///< of the end: steps, memory, times
    std::vector<std::vector<std::string>> work; ///< kind of work, seconds, share
    std::string lastTime;                       ///< of "Time = ..."
    bool ended = false;

    /// Throws CaseError where it cannot be read or is no log of sloshSPHFoam.
    static LogFile read(const std::filesystem::path& file);
};

} // namespace slosh
