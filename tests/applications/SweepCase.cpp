// SPDX-License-Identifier: GPL-3.0-or-later
#include "SweepCase.hpp"

#include <gtest/gtest.h>

#include <sstream>

namespace slosh
{

namespace fs = std::filesystem;

namespace
{

std::vector<std::string> cellsOf(const std::string& line)
{
    std::vector<std::string> cells;
    std::istringstream in(line);
    for (std::string cell; std::getline(in, cell, '\t');)
    {
        cells.push_back(cell);
    }
    return cells;
}

} // namespace

SweepTable tableOf(const CaseDirectory& theCase, const std::string& file)
{
    std::istringstream lines(theCase.text(sweepFolder + file));
    std::string line;
    std::getline(lines, line);
    const auto names = cellsOf(line);
    SweepTable rows;
    while (std::getline(lines, line))
    {
        const auto cells = cellsOf(line);
        EXPECT_EQ(cells.size(), names.size()) << line;
        rows.emplace_back();
        for (std::size_t k = 0; k < cells.size(); ++k)
        {
            rows.back()[names.at(k)] = cells[k];
        }
    }
    return rows;
}

SweepCase::SweepCase()
{
    edit("system/controlDict", "endTime 0.1", "endTime 0.01");
    write("system/blockParticlesDict", "particleSpacing 0.02;\n");
    for (const std::string function : {"gauges", "pressure"})
    {
        // Ten samples of each.
        std::string dict = text("system/controlDict");
        const auto at = dict.find("writeInterval 0.01", dict.find(function));
        write("system/controlDict", dict.replace(at, 18, "writeInterval 0.001"));
    }
}

void SweepCase::writeSweep(const std::string& axes, const std::string& results, const std::string& more) const
{
    write("system/sweepDict", "axes { " + axes + " }\nresults { " + results + " }\n" + more + "\n");
}

std::set<std::string> SweepCase::runs() const
{
    std::set<std::string> names;
    for (const auto& item : fs::directory_iterator(path() / sweepFolder / "runs"))
    {
        names.insert(item.path().filename().string());
    }
    return names;
}

std::map<std::string, fs::file_time_type> SweepCase::timesOfRuns() const
{
    std::map<std::string, fs::file_time_type> times;
    for (const auto& item : fs::recursive_directory_iterator(path() / sweepFolder / "runs"))
    {
        times[item.path().string()] = fs::last_write_time(item);
    }
    return times;
}

} // namespace slosh
