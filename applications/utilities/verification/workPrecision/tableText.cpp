// SPDX-License-Identifier: GPL-3.0-or-later
#include "tableText.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iomanip>
#include <sstream>

namespace slosh
{

namespace
{

using Cells = std::array<std::string, 15>;

std::string cellText(double value, int digits)
{
    std::ostringstream text;
    text << std::setprecision(digits) << value;
    return std::isnan(value) ? "nan" : text.str();
}

std::vector<Cells> cellsOf(const std::string& caseName, const std::vector<ErrorTable>& tables)
{
    std::vector<Cells> all{
        {"case", "particleSpacing", "scheme", "error", "cpuSeconds", "wallSeconds", "steps", "evaluations", "particles",
         "peakMemoryMB", "observedOrder", "figure", "comparison", "run", "status"}};
    for (const ErrorTable& table : tables)
    {
        for (const Row& row : table.rows)
        {
            const Outcome& outcome = row.run->outcome;
            all.push_back(
                {caseName, cellText(row.spacing, 6), row.run->setting.scheme, cellText(row.error, 6),
                 cellText(outcome.cpuSeconds, 4), cellText(outcome.wallSeconds, 4), std::to_string(outcome.steps),
                 std::to_string(outcome.evaluations), std::to_string(outcome.particles),
                 cellText(outcome.peakMemory, 4), cellText(row.order, 4), cellText(row.figure, 6),
                 table.comparison->name, row.run->setting.name, outcome.finished() ? "finished" : "failed"}
            );
        }
    }
    return all;
}

} // namespace

std::string csvText(const std::string& caseName, const std::vector<ErrorTable>& tables)
{
    std::string text;
    for (const Cells& cells : cellsOf(caseName, tables))
    {
        for (std::size_t k = 0; k < cells.size(); ++k)
        {
            text += (k == 0 ? "" : ",") + cells[k];
        }
        text += "\n";
    }
    return text;
}

std::string alignedText(const std::string& caseName, const std::vector<ErrorTable>& tables)
{
    const auto all = cellsOf(caseName, tables);
    std::array<std::size_t, std::tuple_size_v<Cells>> width{};
    for (const Cells& cells : all)
    {
        for (std::size_t k = 0; k < cells.size(); ++k)
        {
            width[k] = std::max(width[k], cells[k].size());
        }
    }
    std::ostringstream text;
    for (const Cells& cells : all)
    {
        text << (&cells == &all.front() ? "# " : "  ");
        for (std::size_t k = 0; k < cells.size(); ++k)
        {
            const bool isLast = k + 1 == cells.size();
            text << std::left << std::setw(isLast ? 0 : static_cast<int>(width[k]) + 2) << cells[k];
        }
        text << "\n";
    }
    return text.str();
}

} // namespace slosh
