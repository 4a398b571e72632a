// SPDX-License-Identifier: GPL-3.0-or-later
// A case as one page for a browser: what it is, what it has sampled, what was made of that.
#include "common/Program.hpp"
#include "common/selectTimes.hpp"
#include "sections.hpp"
#include "snapshots.hpp"

#include "base/writeFile.hpp"
#include "case/Case.hpp"

#include <charconv>
#include <cmath>
#include <iostream>

using namespace slosh;

namespace
{

namespace fs = std::filesystem;

double timeOf(const Program& program, const std::string& option)
{
    if (!program.has(option))
    {
        return -INFINITY;
    }
    const std::string text = program.value(option);
    double time = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), time);
    if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(time))
    {
        throw CaseError("-" + option + " is " + text + "; expected a time [s]");
    }
    return time;
}

std::optional<LogFile> readLog(const Case& theCase, const Program& program, const std::string& name)
{
    const fs::path file = theCase.root() / name;
    return fs::exists(file) || program.has("log") ? std::optional(LogFile::read(file)) : std::nullopt;
}

std::string subtitleOf(const std::optional<LogFile>& log)
{
    if (!log)
    {
        return "Reported by SloshSPH " + Program::version();
    }
    return "Run on " + log->date + " by SloshSPH " + log->version + ", reported by SloshSPH " + Program::version();
}

/// The last time that there is something of.
double lastTimeOf(const std::vector<TimeDirectory>& times, const std::vector<SampledFile>& files)
{
    double last = times.empty() ? 0 : times.back().value;
    for (const SampledFile& file : files)
    {
        last = std::max(last, file.series(file.columns.front()).t.back());
    }
    return last;
}

void writeSnapshots(HtmlPage& page, const Case& theCase, const Tank& tank, const std::vector<TimeDirectory>& times)
{
    page.section("snapshots", "Snapshots");
    if (times.empty())
    {
        page.paragraph("The case has no written times.");
        return;
    }
    page.paragraph("Liquid coloured by pressure, and the walls of the tank.");
    page.beginRow();
    for (const SnapshotPicture& picture : snapshotPictures(theCase, tank, times))
    {
        page.picture("png", picture.png, picture.caption);
    }
    page.endRow();
}

void sloshReport(const Program& program)
{
    const Case theCase(program.caseFolder());
    const fs::path postProcessing = theCase.root() / "postProcessing";
    const std::string usual = "postProcessing/report.html";
    const fs::path output = program.has("output") ? fs::path(program.value("output")) : theCase.root() / usual;
    const double from = timeOf(program, "from");
    const std::string logName = program.has("log") ? program.value("log") : "log.sloshSPHFoam";

    const auto times = theCase.times();
    const auto files = findSampledFiles(postProcessing);
    if (times.empty() && files.empty())
    {
        throw CaseError(
            theCase.root().string() +
            ": no time directories and no samples found; run blockParticles and sloshSPHFoam first"
        );
    }
    const bool chosen = program.has("time") || program.has("latestTime") || program.has("noZero");
    const auto shown = chosen ? selectTimes(theCase, program) : spread(times, 4);
    const auto log = readLog(theCase, program, logName);
    const SetUp set = SetUp::read(theCase);
    const double last = lastTimeOf(times, files);
    if (from > last)
    {
        throw CaseError(
            "-from is " + program.value("from") + "; expected a time before the last one, " + number(last, 8) + " s"
        );
    }
    const double omega = set.motionFrequency(0, last);

    HtmlPage page(theCase.name(), subtitleOf(log));
    writeSetUp(page, set, log);
    writeFrequencies(page, set, omega);
    writeSnapshots(page, theCase, set.scene.tank, shown);
    writeHistories(page, files, from);
    writeSpectra(page, files, from, set, omega);
    writeComparisons(page, postProcessing);
    writePeaks(page, postProcessing);
    writeErrors(page, postProcessing);
    writeTiming(page, log, logName);
    writeFile(output, page.text());
    std::cout << "Wrote " << (program.has("output") ? output.string() : usual) << "\n";
}

} // namespace

int main(int argc, char** argv)
{
    Program program(
        "sloshReport", "Writes a report of a case as one self-contained HTML page.",
        "sloshReport -case tutorials/rollingTank/roll8deg4rad -from 10"
    );
    addTimeOptions(program);
    program.addOption("from", "s", "start time of histories and spectra; earlier samples are omitted");
    program.addOption("log", "file", "the solver's log; default: log.sloshSPHFoam");
    program.addOption("output", "page", "output file; default: postProcessing/report.html of the case");
    program.addFile("constant/*, system/*", "read: the set-up of the case");
    program.addFile(
        "<time>/", "read: the particles of four times, or of those selected by -time, -latestTime, -noZero"
    );
    program.addFile(
        "postProcessing/", "read: samples and the results of compareSamples, peakStatistics, workPrecision"
    );
    program.addFile("postProcessing/report.html", "written");
    return program.run(argc, argv, [&] { sloshReport(program); });
}
