// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "HtmlPage.hpp"
#include "SampledFile.hpp"
#include "logFile.hpp"
#include "setUp.hpp"

#include <filesystem>
#include <optional>

namespace slosh
{

// The sections of a report, each of what is there of a case; what is not there is said in a sentence.

void writeSetUp(HtmlPage& page, const SetUp& set, const std::optional<LogFile>& log);
void writeFrequencies(HtmlPage& page, const SetUp& set, double motionFrequency);
/// `from`: samples before that time are left out, [s].
void writeHistories(HtmlPage& page, const std::vector<SampledFile>& files, double from);
void writeSpectra(
    HtmlPage& page, const std::vector<SampledFile>& files, double from, const SetUp& set, double motionFrequency
);
void writeComparisons(HtmlPage& page, const std::filesystem::path& postProcessing);
void writePeaks(HtmlPage& page, const std::filesystem::path& postProcessing);
void writeErrors(HtmlPage& page, const std::filesystem::path& postProcessing);
void writeTiming(HtmlPage& page, const std::optional<LogFile>& log, const std::string& logName);

} // namespace slosh
