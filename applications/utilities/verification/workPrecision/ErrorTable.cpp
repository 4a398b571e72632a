// SPDX-License-Identifier: GPL-3.0-or-later
#include "ErrorTable.hpp"

#include "verification/gridConvergence.hpp"
#include "verification/paretoFront.hpp"

#include <algorithm>
#include <cmath>

namespace slosh
{

namespace
{

/// f0 of the three finest runs that have a figure, NaN where there are no three or they have no order.
double richardsonLimit(const std::vector<Row*>& rows)
{
    std::vector<const Row*> known;
    std::copy_if(
        rows.rbegin(), rows.rend(), std::back_inserter(known),
        [](const Row* row) { return row->run->outcome.finished() && std::isfinite(row->figure); }
    );
    if (known.size() < 3)
    {
        return Outcome::unknown;
    }
    const double f1 = known[0]->figure, f2 = known[1]->figure, f3 = known[2]->figure;
    const auto p = orderOfThreeGrids({known[0]->spacing, known[1]->spacing, known[2]->spacing}, f2 - f1, f3 - f2);
    return p ? extrapolated(f1, f2, known[1]->spacing / known[0]->spacing, *p) : Outcome::unknown;
}

/// What is exact is off by round-off: errors are compared, and drawn, by their logarithms.
constexpr double roundOff = 1e-16;

void findOrders(const std::vector<Row*>& rows)
{
    const Row* coarser = nullptr;
    for (Row* row : rows)
    {
        if (!row->hasError())
        {
            continue;
        }
        if (coarser != nullptr && coarser->spacing > row->spacing)
        {
            row->order = std::log(coarser->error / row->error) / std::log(coarser->spacing / row->spacing);
        }
        coarser = row;
    }
}

} // namespace

std::vector<std::string> ErrorTable::schemes() const
{
    std::vector<std::string> schemes;
    for (const Row& row : rows)
    {
        if (schemes.empty() || schemes.back() != row.run->setting.scheme)
        {
            schemes.push_back(row.run->setting.scheme);
        }
    }
    return schemes;
}

std::vector<const Row*> ErrorTable::rowsOf(const std::string& scheme) const
{
    std::vector<const Row*> some;
    for (const Row& row : rows)
    {
        if (row.run->setting.scheme == scheme)
        {
            some.push_back(&row);
        }
    }
    return some;
}

std::vector<const Row*> ErrorTable::paretoFront() const
{
    std::vector<double> cost, error;
    for (const Row& row : rows)
    {
        cost.push_back(row.run->outcome.cpuSeconds);
        error.push_back(row.hasError() ? row.error : Outcome::unknown);
    }
    std::vector<const Row*> front;
    for (const std::size_t i : slosh::paretoFront(cost, error))
    {
        front.push_back(&rows[i]);
    }
    return front;
}

ErrorTable errorTable(const std::vector<Run>& runs, const std::vector<Comparison>& comparisons, std::size_t index)
{
    ErrorTable table{&comparisons[index], {}};
    std::vector<std::string> schemes;
    for (const Run& run : runs)
    {
        const auto& outcome = run.outcome;
        const double spacing = std::isfinite(outcome.spacing) ? outcome.spacing : run.setting.wantedSpacing;
        const Compared compared = index < run.compared.size() ? run.compared[index] : Compared();
        // Where another run is the reference, 0 is this run itself: no error.
        const double error = table.comparison->needsRun() ? compared.error : std::max<double>(compared.error, roundOff);
        table.rows.push_back({&run, spacing, compared.figure, error, Outcome::unknown});
        if (std::find(schemes.begin(), schemes.end(), run.setting.scheme) == schemes.end())
        {
            schemes.push_back(run.setting.scheme);
        }
    }
    const auto place = [&](const Row& row)
    { return std::find(schemes.begin(), schemes.end(), row.run->setting.scheme) - schemes.begin(); };
    std::stable_sort(
        table.rows.begin(), table.rows.end(),
        [&](const Row& a, const Row& b) { return place(a) != place(b) ? place(a) < place(b) : a.spacing > b.spacing; }
    );
    for (const auto& scheme : schemes)
    {
        std::vector<Row*> rows;
        for (Row& row : table.rows)
        {
            if (row.run->setting.scheme == scheme)
            {
                rows.push_back(&row);
            }
        }
        if (table.comparison->reference == Comparison::Reference::richardson)
        {
            const double f0 = richardsonLimit(rows);
            for (Row* row : rows)
            {
                row->error = std::abs(row->figure / f0 - 1);
            }
        }
        findOrders(rows);
    }
    return table;
}

} // namespace slosh
