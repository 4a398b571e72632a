// SPDX-License-Identifier: GPL-3.0-or-later
#include "ErrorTable.hpp"

#include "FigureUncertainty.hpp"

#include "verification/paretoFront.hpp"

#include <algorithm>
#include <cmath>

namespace slosh
{

namespace
{

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

std::vector<const Row*> pointersTo(const std::vector<Row>& rows)
{
    std::vector<const Row*> all(rows.size());
    std::transform(rows.begin(), rows.end(), all.begin(), [](const Row& row) { return &row; });
    return all;
}

/// Each once, in the order of the rows.
std::vector<std::string> valuesOf(const std::vector<const Row*>& rows, std::string Setting::*part)
{
    std::vector<std::string> values;
    for (const Row* row : rows)
    {
        const std::string& value = row->run->setting.*part;
        if (std::find(values.begin(), values.end(), value) == values.end())
        {
            values.push_back(value);
        }
    }
    return values;
}

std::vector<const Row*> rowsWith(const std::vector<Row>& rows, std::string Setting::*part, const std::string& value)
{
    std::vector<const Row*> some;
    for (const Row& row : rows)
    {
        if (row.run->setting.*part == value)
        {
            some.push_back(&row);
        }
    }
    return some;
}

/// Errors against the limit that the figures of each family have at spacing 0.
void takeLimits(ErrorTable& table, double schemeOrder)
{
    for (const auto& family : table.families())
    {
        const auto band = figureUncertainty(table.rowsOfFamily(family), *table.comparison, schemeOrder).band;
        for (Row& row : table.rows)
        {
            if (row.run->setting.family == family)
            {
                row.error = band ? std::max(std::abs(row.figure / band->fit.limit(0) - 1), roundOff) : Outcome::unknown;
            }
        }
    }
}

} // namespace

std::vector<std::string> ErrorTable::schemes() const
{
    return valuesOf(pointersTo(rows), &Setting::scheme);
}

std::vector<std::string> ErrorTable::families() const
{
    return valuesOf(pointersTo(rows), &Setting::family);
}

std::vector<std::string> ErrorTable::schemesOf(const std::string& family) const
{
    return valuesOf(rowsWith(rows, &Setting::family, family), &Setting::scheme);
}

std::vector<const Row*> ErrorTable::rowsOf(const std::string& scheme) const
{
    return rowsWith(rows, &Setting::scheme, scheme);
}

std::vector<const Row*> ErrorTable::rowsOfFamily(const std::string& family) const
{
    auto some = rowsWith(rows, &Setting::family, family);
    std::stable_sort(some.begin(), some.end(), [](const Row* a, const Row* b) { return a->spacing > b->spacing; });
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

ErrorTable errorTable(
    const std::vector<Run>& runs, const std::vector<Comparison>& comparisons, std::size_t index, double schemeOrder
)
{
    ErrorTable table{&comparisons[index], {}};
    for (const Run& run : runs)
    {
        const auto& outcome = run.outcome;
        const double spacing = std::isfinite(outcome.spacing) ? outcome.spacing : run.setting.wantedSpacing;
        const Compared compared = index < run.compared.size() ? run.compared[index] : Compared();
        // Where another run is the reference, 0 is this run itself: no error.
        const double error = table.comparison->needsRun() ? compared.error : std::max<double>(compared.error, roundOff);
        table.rows.push_back(
            {&run, spacing, compared.figure, error, Outcome::unknown, compared.standardError, compared.count}
        );
    }
    const auto schemes = table.schemes();
    const auto place = [&](const Row& row)
    { return std::find(schemes.begin(), schemes.end(), row.run->setting.scheme) - schemes.begin(); };
    std::stable_sort(
        table.rows.begin(), table.rows.end(),
        [&](const Row& a, const Row& b) { return place(a) != place(b) ? place(a) < place(b) : a.spacing > b.spacing; }
    );
    if (table.comparison->reference == Comparison::Reference::richardson)
    {
        takeLimits(table, schemeOrder);
    }
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
        findOrders(rows);
    }
    return table;
}

} // namespace slosh
