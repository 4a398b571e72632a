// SPDX-License-Identifier: GPL-3.0-or-later
#include "table.hpp"

#include "base/numberText.hpp"

#include <algorithm>
#include <cmath>

namespace slosh
{

namespace
{

using Cells = std::vector<std::string>;

std::string cellText(double value)
{
    return std::isnan(value) ? "nan" : numberText(value, 6);
}

Cells namesOf(const Sweep& sweep, std::size_t modes)
{
    Cells cells{"# case"};
    for (const auto& axis : sweep.axes)
    {
        cells.push_back(axis.title());
    }
    cells.push_back("omega [rad/s]");
    for (std::size_t n = 1; n <= modes; ++n)
    {
        cells.push_back("omega" + std::to_string(n) + " [rad/s]");
    }
    return cells;
}

Cells valuesOf(const SweptCase& one, const Sweep& sweep, std::size_t modes)
{
    Cells cells{std::to_string(one.number)};
    for (std::size_t k = 0; k < sweep.axes.size(); ++k)
    {
        cells.push_back(sweep.axes[k].values[one.setting.values[k]].label);
    }
    cells.push_back(cellText(one.facts.omega.value_or(Outcome::unknown)));
    for (std::size_t n = 0; n < modes; ++n)
    {
        cells.push_back(
            cellText(n < one.facts.naturalFrequencies.size() ? one.facts.naturalFrequencies[n] : Outcome::unknown)
        );
    }
    return cells;
}

std::string joined(const Cells& cells)
{
    std::string line;
    for (const auto& cell : cells)
    {
        std::string text = cell;
        std::replace(text.begin(), text.end(), '\t', ' ');
        line += (line.empty() ? "" : "\t") + text;
    }
    return line + "\n";
}

} // namespace

std::string tableText(const Sweep& sweep, const std::vector<CaseState>& states)
{
    Cells names = namesOf(sweep, 1);
    for (const Result& result : sweep.results)
    {
        names.push_back(result.title());
        if (result.hasUncertainty)
        {
            names.push_back(result.name + " +-");
        }
        if (result.hasReference)
        {
            names.push_back(result.name + " reference");
        }
    }
    names.insert(names.end(), {"CPU [s]", "status", "reason"});
    std::string text = joined(names);
    for (std::size_t i = 0; i < states.size(); ++i)
    {
        Cells cells = valuesOf(sweep.cases[i], sweep, 1);
        for (std::size_t k = 0; k < sweep.results.size(); ++k)
        {
            const CaseState::Figure& figure = states[i].figures[k];
            cells.push_back(cellText(figure.value));
            if (sweep.results[k].hasUncertainty)
            {
                cells.push_back(cellText(figure.uncertainty));
            }
            if (sweep.results[k].hasReference)
            {
                cells.push_back(cellText(figure.reference));
            }
        }
        const bool ended = states[i].stage == CaseState::Stage::finished || states[i].stage == CaseState::Stage::failed;
        cells.push_back(cellText(ended ? states[i].outcome.cpuSeconds : Outcome::unknown));
        cells.push_back(states[i].word());
        cells.push_back(states[i].reason().empty() ? "-" : states[i].reason());
        text += joined(cells);
    }
    return text;
}

std::string casesText(const Sweep& sweep, const std::vector<CaseState>& states)
{
    std::vector<Cells> rows{namesOf(sweep, 3)};
    rows.front().front() = "case";
    rows.front().push_back("status");
    for (std::size_t i = 0; i < states.size(); ++i)
    {
        rows.push_back(valuesOf(sweep.cases[i], sweep, 3));
        rows.back().push_back(states[i].word());
    }
    std::vector<std::size_t> width(rows.front().size(), 0);
    for (const Cells& cells : rows)
    {
        for (std::size_t k = 0; k < cells.size(); ++k)
        {
            width[k] = std::max(width[k], cells[k].size());
        }
    }
    std::string text;
    for (const Cells& cells : rows)
    {
        for (std::size_t k = 0; k < cells.size(); ++k)
        {
            text += (k == 0 ? "" : "  ") + std::string(width[k] - cells[k].size(), ' ') + cells[k];
        }
        text += "\n";
    }
    return text;
}

} // namespace slosh
