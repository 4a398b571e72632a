// SPDX-License-Identifier: GPL-3.0-or-later
// The peaks of sampled series over a threshold, and their statistics.
#include "PeakReport.hpp"
#include "common/Program.hpp"

#include "base/writeFile.hpp"
#include "case/Case.hpp"

#include <iostream>

using namespace slosh;

namespace
{

void peakStatistics(const Case& theCase, const std::string& dictionary)
{
    const auto postProcessing = theCase.root() / "postProcessing";
    std::vector<PeakReport> reports;
    for (const PeakQuery& query : readPeakQueries(theCase.dictionary(dictionary)))
    {
        reports.push_back(reportPeaks(postProcessing, query));
    }
    // All is known to be sound before the first file is written.
    for (const PeakReport& report : reports)
    {
        const auto folder = postProcessing / "peakStatistics" / report.query.name;
        std::cout << report.query.name << "\n" << report.statisticsText();
        std::cout << (report.remark.empty() ? "" : "(" + report.remark + ")\n");
        for (const auto& [file, text] :
             {std::pair{folder / "peaks.dat", report.peaksText()},
              std::pair{folder / "statistics.dat", report.statisticsText()}})
        {
            writeFile(file, text);
            std::cout << "Wrote " << file.lexically_relative(theCase.root()).string() << "\n";
        }
        std::cout << "\n";
    }
}

} // namespace

int main(int argc, char** argv)
{
    Program program(
        "peakStatistics",
        "Peaks of sampled series above a threshold and their statistics, as set in system/peakStatisticsDict.",
        "peakStatistics -case tutorials/rollingTank/roll8deg4rad"
    );
    program.addOption("dict", "file", "the peaks to evaluate; default: system/peakStatisticsDict");
    program.addFile("system/peakStatisticsDict", "read: the samples and peaks to evaluate");
    program.addFile("postProcessing/<function>/", "read: the samples");
    program.addFile("postProcessing/peakStatistics/<entry>/", "written: peaks.dat, statistics.dat");
    program.addDictionary(
        {"system/peakStatisticsDict",
         "Peaks that peakStatistics evaluates from samples after a run: any number of entries, each with its own name, "
         "which write postProcessing/peakStatistics/<name>/peaks.dat and statistics.dat.",
         peakStatisticsDictKeys}
    );
    return program.run(
        argc, argv,
        [&]
        {
            peakStatistics(
                Case(program.caseFolder()), program.has("dict") ? program.value("dict") : "system/peakStatisticsDict"
            );
        }
    );
}
