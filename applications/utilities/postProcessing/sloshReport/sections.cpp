// SPDX-License-Identifier: GPL-3.0-or-later
#include "sections.hpp"

#include "Figure.hpp"
#include "contentOf.hpp"

#include <algorithm>
#include <cctype>
#include <numbers>
#include <sstream>

namespace slosh
{

namespace
{

namespace fs = std::filesystem;

/// What is in a folder, sorted; nothing where there is none.
std::vector<fs::path> itemsOf(const fs::path& folder)
{
    std::error_code failure;
    std::vector<fs::path> items;
    for (fs::directory_iterator at(folder, failure), end; !failure && at != end; at.increment(failure))
    {
        items.push_back(at->path());
    }
    std::sort(items.begin(), items.end());
    return items;
}

std::vector<std::string> cellsOf(const std::string& line)
{
    std::vector<std::string> cells(1);
    for (const char c : line)
    {
        if (c == '\t')
        {
            cells.emplace_back();
        }
        else
        {
            cells.back() += c;
        }
    }
    return cells;
}

/// What compareSamples has written of a comparison with a series: time, samples, reference and its band.
void addComparedSeries(HtmlPage& page, const fs::path& file)
{
    Figure figure{"time [s]", "in the unit of the comparison", {}, {}, 0, 0};
    const std::string head = contentOf(file).substr(0, 60);
    figure.curves.push_back({"samples", thinned(readTimeSeries(file, 1))});
    figure.curves.push_back({"reference", thinned(readTimeSeries(file, 2)), true});
    if (head.find("  low  high\n") != std::string::npos)
    {
        figure.curves.push_back({"low", thinned(readTimeSeries(file, 3)), true});
        figure.curves.push_back({"high", thinned(readTimeSeries(file, 4)), true});
    }
    page.picture("svg+xml", draw(figureTerminal, figure.script()), "Comparison " + file.stem().string());
}

/// What peakStatistics has written of one entry.
struct PeakFigures
{
    std::vector<std::pair<std::string, std::string>> figures; ///< name; value, with its bounds where it has some
    std::string remark;                                       ///< what was counted
};

PeakFigures readPeakFigures(const fs::path& file)
{
    PeakFigures peaks;
    std::istringstream text(contentOf(file));
    for (std::string line; std::getline(text, line);)
    {
        if (line.rfind("# figure", 0) == 0)
        {
            continue;
        }
        if (line.rfind("# ", 0) == 0)
        {
            const bool whole = std::isalnum(static_cast<unsigned char>(line.back())) != 0;
            peaks.remark += (peaks.remark.empty() ? "" : " ") + line.substr(2) + (whole ? "." : "");
            continue;
        }
        std::istringstream words(line);
        std::string name;
        double value = 0, low = 0, high = 0;
        if (words >> name >> value)
        {
            const bool bounded = static_cast<bool>(words >> low >> high);
            peaks.figures.emplace_back(
                name, number(value) + (bounded ? " (" + number(low) + " to " + number(high) + ")" : "")
            );
        }
    }
    return peaks;
}

} // namespace

void writeSetUp(HtmlPage& page, const SetUp& set, const std::optional<LogFile>& log)
{
    page.section("setUp", "Set-up");
    page.facts(set.facts);
    if (log && !log->words.empty())
    {
        std::string text;
        for (const std::string& line : log->words)
        {
            text += line + "\n";
        }
        page.heading("Computed and omitted by the solver");
        page.preformatted(text);
    }
    if (log && !log->warnings.empty())
    {
        page.heading("Warnings of the run");
        for (const std::string& warning : log->warnings)
        {
            page.paragraph(warning);
        }
    }
}

void writeFrequencies(HtmlPage& page, const SetUp& set, double motionFrequency)
{
    page.section("frequencies", "Natural frequencies");
    if (!set.naturalFrequencies.empty() && !set.scene.tank.liquidIsBox())
    {
        page.paragraph(
            "For a box with the breadth of the still surface and the depth of the tank, not for this " +
            set.scene.tank.walls().name() + "."
        );
    }
    if (set.naturalFrequencies.empty())
    {
        page.paragraph(
            "The liquid does not extend from wall to wall under gravity: linear theory has no natural frequency for it."
        );
    }
    std::vector<std::vector<std::string>> rows;
    const auto add = [&](const std::string& name, double omega)
    {
        rows.push_back(
            {name, number(omega), number(omega / (2 * std::numbers::pi)), number(2 * std::numbers::pi / omega)}
        );
        if (motionFrequency > 0)
        {
            rows.back().push_back(number(motionFrequency / omega, 3));
        }
    };
    for (std::size_t n = 0; n < set.naturalFrequencies.size(); ++n)
    {
        add("omega" + std::to_string(n + 1) + ", linear theory", set.naturalFrequencies[n]);
    }
    if (motionFrequency > 0)
    {
        add("motion, dominant frequency of its acceleration", motionFrequency);
    }
    std::vector<std::string> head = {"", "omega [rad/s]", "frequency [Hz]", "period [s]"};
    if (motionFrequency > 0)
    {
        head.emplace_back("ratio of motion to this");
    }
    if (!rows.empty())
    {
        page.table(head, rows);
    }
    if (motionFrequency == 0)
    {
        page.paragraph(
            set.scene.motion->isStationary() ? "The tank is at rest."
                                             : "The run covers fewer than three periods of the motion."
        );
    }
}

void writeComparisons(HtmlPage& page, const fs::path& postProcessing)
{
    const fs::path folder = postProcessing / "compareSamples";
    page.section("comparisons", "Comparisons");
    std::vector<std::vector<std::string>> rows;
    std::istringstream table(contentOf(folder / "comparisons.tsv"));
    for (std::string line; std::getline(table, line);)
    {
        if (!line.empty() && line[0] != '#')
        {
            rows.push_back(cellsOf(line));
        }
    }
    if (rows.empty())
    {
        page.paragraph("No comparisons: compareSamples makes those set in system/comparisonsDict.");
        return;
    }
    page.table({"what", "figure", "reference", "error", "source"}, rows);
    page.beginRow();
    for (const fs::path& file : itemsOf(folder))
    {
        if (file.extension() == ".dat" && file.stem() != "comparisons" &&
            contentOf(file).rfind("# time  samples  reference", 0) == 0)
        {
            addComparedSeries(page, file);
        }
    }
    page.endRow();
}

void writePeaks(HtmlPage& page, const fs::path& postProcessing)
{
    page.section("peaks", "Peak statistics");
    std::vector<std::string> head = {"figure"};
    std::vector<std::vector<std::string>> rows;
    std::vector<std::pair<std::string, std::string>> remarks;
    for (const fs::path& entry : itemsOf(postProcessing / "peakStatistics"))
    {
        const PeakFigures peaks = readPeakFigures(entry / "statistics.dat");
        if (peaks.figures.empty())
        {
            continue;
        }
        for (const auto& figure : peaks.figures)
        {
            auto row = std::find_if(rows.begin(), rows.end(), [&](const auto& one) { return one[0] == figure.first; });
            if (row == rows.end())
            {
                row = rows.insert(row, {figure.first});
            }
            row->resize(head.size());
            row->push_back(figure.second);
        }
        head.push_back(entry.filename().string());
        remarks.emplace_back(head.back(), peaks.remark);
    }
    if (rows.empty())
    {
        page.paragraph("No peak statistics: peakStatistics evaluates those set in system/peakStatisticsDict.");
        return;
    }
    page.table(head, rows);
    page.facts(remarks);
}

void writeErrors(HtmlPage& page, const fs::path& postProcessing)
{
    page.section("errors", "Error against run time");
    bool any = false;
    for (const fs::path& folder : itemsOf(postProcessing / "workPrecision"))
    {
        const std::string picture = contentOf(folder / "workPrecision.svg"), words = contentOf(folder / "summary.txt");
        if (!picture.empty())
        {
            page.picture("svg+xml", picture, "Error against CPU time, from workPrecision");
        }
        if (!words.empty())
        {
            page.preformatted(words);
        }
        any = any || !picture.empty() || !words.empty();
    }
    if (!any)
    {
        page.paragraph("Unknown: the case has not been run at several spacings. workPrecision runs those set in "
                       "system/workPrecisionDict.");
    }
}

void writeTiming(HtmlPage& page, const std::optional<LogFile>& log, const std::string& logName)
{
    page.section("timing", "Timing");
    if (!log)
    {
        page.paragraph("There is no " + logName + " in the case: sloshSPHFoam > " + logName + " creates it.");
        return;
    }
    if (!log->ended)
    {
        page.paragraph(
            "The run has not finished" +
            (log->lastTime.empty() ? "." : "; the last time in its log is " + log->lastTime + " s.")
        );
    }
    if (!log->facts.empty())
    {
        page.facts(log->facts);
    }
    if (!log->work.empty())
    {
        page.heading("Wall-clock time");
        page.table({"kind of work", "seconds", "share"}, log->work);
    }
}

} // namespace slosh
