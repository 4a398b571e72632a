// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "CaseDirectory.hpp"

#include <set>
#include <vector>

namespace slosh
{

/// Where sloshSweep writes.
inline const std::string sweepFolder = "postProcessing/sweep/0/";

/// The rows of a sweep's table, each by the names of its columns.
using SweepTable = std::vector<std::map<std::string, std::string>>;
SweepTable tableOf(const CaseDirectory& theCase, const std::string& file = "sweep.tsv");

/// The small rolling tank at ten by five particles for 0.01 s, to be swept.
class SweepCase : public CaseDirectory
{
public:
    SweepCase();

    void writeSweep(const std::string& axes, const std::string& results, const std::string& more = "") const;
    SweepTable table() const { return tableOf(*this); }
    std::set<std::string> runs() const; ///< the names of their folders
    /// When each file of the cases was last written.
    std::map<std::string, std::filesystem::file_time_type> timesOfRuns() const;
};

} // namespace slosh
