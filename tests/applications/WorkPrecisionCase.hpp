// SPDX-License-Identifier: GPL-3.0-or-later
// A case whose energy is known in closed form, and the study of it.
#pragma once

#include "CaseDirectory.hpp"

#include <gtest/gtest.h>

#include <map>
#include <sstream>

namespace slosh
{

class WorkPrecision : public testing::Test
{
protected:
    const std::string folder = "postProcessing/workPrecision/0/";

    WorkPrecision()
    {
        case_.edit("system/controlDict", "endTime 0.1", "endTime 0.01");
        // Without gravity the lattice is not compressed by its weight.
        case_.edit("constant/g", "(0 0 -9.81)", "(0 0 0)");
        case_.write(
            "constant/fluidProperties",
            case_.text("constant/fluidProperties") + "equationOfState { type Tait; gamma 7; speedOfSound 10; }\n"
        );
    }

    void write(const std::string& axes, const std::string& reference, const std::string& more = "") const
    {
        case_.write(
            "system/workPrecisionDict",
            "axes { " + axes +
                " }\ncomparisons { energy { description \"kinetic "
                "energy\"; samples energies/energies.dat; column 1; unit J; quantity value; time 0; "
                "reference { " +
                reference + " } } }\n" + more
        );
    }

    /// The rows of the table by run, each by column.
    std::map<std::string, std::map<std::string, std::string>> table() const
    {
        std::istringstream lines(case_.text(folder + "workPrecision.csv"));
        const auto cellsOf = [](const std::string& line)
        {
            std::vector<std::string> cells;
            std::istringstream in(line);
            for (std::string cell; std::getline(in, cell, ',');)
            {
                cells.push_back(cell);
            }
            return cells;
        };
        std::string line;
        std::getline(lines, line);
        const auto names = cellsOf(line);
        std::map<std::string, std::map<std::string, std::string>> rows;
        while (std::getline(lines, line))
        {
            const auto cells = cellsOf(line);
            EXPECT_EQ(cells.size(), names.size()) << line;
            std::map<std::string, std::string> row;
            for (std::size_t k = 0; k < names.size(); ++k)
            {
                row[names[k]] = cells.at(k);
            }
            rows[row["run"]] = row;
        }
        return rows;
    }

    std::map<std::string, std::filesystem::file_time_type> timesOfRuns() const
    {
        std::map<std::string, std::filesystem::file_time_type> times;
        for (const auto& item : std::filesystem::recursive_directory_iterator(case_.path() / folder / "runs"))
        {
            times[item.path().string()] = std::filesystem::last_write_time(item);
        }
        return times;
    }

    void expectRefused(const std::vector<std::string>& fragments) const
    {
        const Ended ended = case_.run("workPrecision");
        EXPECT_EQ(ended.status, 1);
        for (const auto& fragment : fragments)
        {
            EXPECT_NE(ended.err.find(fragment), std::string::npos) << fragment << " is not in\n" << ended.err;
        }
        EXPECT_FALSE(std::filesystem::exists(case_.path() / "postProcessing"));
    }

    static std::size_t count(const std::string& text, const std::string& words)
    {
        std::size_t n = 0;
        for (auto at = text.find(words); at != std::string::npos; at = text.find(words, at + 1))
        {
            ++n;
        }
        return n;
    }

    CaseDirectory case_;
    const std::string spacings_ =
        "particleSpacing { file \"system/blockParticlesDict\"; entry particleSpacing; values (0.02 0.0143 0.01); }";
    const std::string fourSpacings_ = "particleSpacing { file \"system/blockParticlesDict\"; entry particleSpacing; "
                                      "values (0.025 0.02 0.0143 0.01); }";
    const std::string alphas_ = "alpha { file \"constant/fluidProperties\"; entry viscosity.alpha; values (0.03 0); }";
};

} // namespace slosh
