// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "statistics/TimeSeries.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace slosh
{

/// A file of samples that a function object has written, postProcessing/<function>/<start times>/<file>.
struct SampledFile
{
    struct Column
    {
        int number = 0;       ///< in the file, from 0; vectors count three
        std::string name;     ///< "p0", "total_y"
        std::string place;    ///< of a probe or gauge: "(0 -0.46 0.06)"
        std::string quantity; ///< "pressure"
        std::string unit;     ///< "Pa"; empty: none
        bool usual = true;    ///< one of those that say most
    };

    std::string function;                     ///< its folder below postProcessing
    std::string file;                         ///< "height.dat"
    std::vector<std::filesystem::path> parts; ///< of the runs that went on, in the order of their start times
    std::vector<Column> columns;
    bool changed = false; ///< earlier parts had other columns and are not among `parts`

    std::string name() const; ///< "forces/moment"; of probes and where both are called alike the function alone
    /// One column of all parts, a later one replacing what it repeats. Throws CaseError: a malformed row.
    TimeSeries series(const Column& column) const;
};

/// All of a case, pressures first, then levels, loads, energies and the rest. Files without rows are left out.
std::vector<SampledFile> findSampledFiles(const std::filesystem::path& postProcessing);

} // namespace slosh
