// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace slosh
{

/// One file of a series and the instant it shows, [s].
struct SeriesFile
{
    std::string name;
    double time = 0;
};

/// ParaView's file series, as foamToVTK writes it: {"file-series-version" : "1.0", "files": [{"name", "time"} ...]}.
/// Names are relative to the series file; times keep all their digits. Throws CaseError.
void writeSeries(const std::filesystem::path& file, const std::vector<SeriesFile>& files);

} // namespace slosh
