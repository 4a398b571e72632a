// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <vector>

namespace slosh
{

/// One quantity sampled at rising times.
struct TimeSeries
{
    std::vector<double> t;     ///< [s]
    std::vector<double> value; ///< as many

    std::size_t size() const { return t.size(); }
    bool empty() const { return t.empty(); }

    /// The samples with begin <= t <= end.
    TimeSeries between(double begin, double end) const;
    /// Linear between the two samples around `time`. Throws CaseError beyond the ends.
    double at(double time) const;
};

/// Reads column `column` of a file of samples beside its times, column `timeColumn` (columns count from 0): rows of
/// numbers, separated by blanks, tabs or commas, as OpenFOAM's function objects write them (a vector "(x y z)" is three
/// columns) or as comma-separated text. Lines that begin with '#' and one line of names before the numbers are passed
/// over. Rows that do not rise in time (a restart that went back) replace those they repeat. Throws CaseError: no such
/// file, a row that is too short, a value that is no number, no rows.
TimeSeries readTimeSeries(const std::filesystem::path& file, int column, int timeColumn = 0);

/// The same of several files, one after another: a later one replaces what it repeats.
TimeSeries readTimeSeries(const std::vector<std::filesystem::path>& parts, int column);

/// The samples a run and its restarts wrote: `file` is postProcessing/<function>/<name>, and those of all the start
/// times in between, postProcessing/<function>/<startTime>/<name>, are joined in the order of start times, a later one
/// replacing what it repeats. Throws CaseError where there is none.
TimeSeries readSamples(const std::filesystem::path& file, int column);

} // namespace slosh
