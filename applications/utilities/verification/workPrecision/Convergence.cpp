// SPDX-License-Identifier: GPL-3.0-or-later
#include "Convergence.hpp"

#include "statistics/Quantity.hpp"
#include "verification/gridConvergence.hpp"

#include <algorithm>
#include <cmath>

namespace slosh
{

namespace
{

/// sqrt(sum (c - f)^2/sum (r - mean r)^2) of the series of a coarser and a finer run, r being the reference of the
/// finer: in the unit of the errors.
double changeOfSeries(const Row& coarser, const Row& finer, const Comparison& comparison)
{
    const auto file = [&](const Row& row)
    { return row.run->folder / "postProcessing/compareSamples" / (comparison.name + ".dat"); };
    const TimeSeries coarse = readTimeSeries(file(coarser), 1), fine = readTimeSeries(file(finer), 1);
    const TimeSeries reference = readTimeSeries(file(finer), 2);
    TimeSeries changed;
    for (std::size_t i = 0; i < fine.size(); ++i)
    {
        if (fine.t[i] >= coarse.t.front() && fine.t[i] <= coarse.t.back())
        {
            changed.t.push_back(fine.t[i]);
            changed.value.push_back(reference.value[i] + coarse.at(fine.t[i]) - fine.value[i]);
        }
    }
    return relativeDifference(changed, reference);
}

void findIndex(
    const std::vector<const Row*>& all, const Comparison& comparison, double formalOrder, Convergence& convergence
)
{
    std::vector<const Row*> finest;
    for (auto row = all.rbegin(); row != all.rend() && finest.size() < 3; ++row)
    {
        const bool isKnown = (*row)->run->outcome.finished() && std::isfinite((*row)->figure);
        if (isKnown && (finest.empty() || (*row)->spacing > finest.back()->spacing))
        {
            finest.push_back(*row);
        }
    }
    if (finest.size() < 2)
    {
        return;
    }
    const auto change = [&](std::size_t coarser)
    {
        return comparison.isSeries ? changeOfSeries(*finest[coarser], *finest[coarser - 1], comparison)
                                   : (finest[coarser]->figure - finest[coarser - 1]->figure) / finest[0]->figure;
    };
    const double r = finest[1]->spacing / finest[0]->spacing;
    convergence.grids = static_cast<int>(finest.size());
    if (finest.size() == 2)
    {
        convergence.gridConvergenceIndex = gridConvergenceIndex(change(1), r, formalOrder, safetyOfTwoGrids);
        return;
    }
    convergence.order =
        orderOfThreeGrids({finest[0]->spacing, finest[1]->spacing, finest[2]->spacing}, change(1), change(2));
    if (convergence.order)
    {
        convergence.gridConvergenceIndex = gridConvergenceIndex(change(1), r, *convergence.order, safetyOfThreeGrids);
    }
}

void fit(Convergence& convergence)
{
    const std::size_t used = convergence.floor ? *convergence.floor + 1 : convergence.rows.size();
    std::vector<double> spacing, error, cpuSeconds;
    for (std::size_t i = 0; i < used; ++i)
    {
        const Row& row = *convergence.rows[i];
        if (std::isfinite(row.spacing) && (spacing.empty() || row.spacing < spacing.back()))
        {
            spacing.push_back(row.spacing);
            error.push_back(row.error);
            cpuSeconds.push_back(row.run->outcome.cpuSeconds);
        }
    }
    if (spacing.size() > 1)
    {
        convergence.error = fitPowerLaw(spacing, error);
        if (std::all_of(cpuSeconds.begin(), cpuSeconds.end(), [](double s) { return s > 0; }))
        {
            convergence.cpuSeconds = fitPowerLaw(spacing, cpuSeconds);
        }
    }
}

} // namespace

Convergence convergenceOf(const ErrorTable& table, const std::string& scheme, double formalOrder)
{
    Convergence convergence;
    const auto all = table.rowsOf(scheme);
    std::vector<double> errors;
    for (const Row* row : all)
    {
        if (row->hasError())
        {
            convergence.rows.push_back(row);
            errors.push_back(row->error);
        }
    }
    convergence.floor = errorFloor(errors);
    fit(convergence);
    findIndex(all, *table.comparison, formalOrder, convergence);
    return convergence;
}

} // namespace slosh
