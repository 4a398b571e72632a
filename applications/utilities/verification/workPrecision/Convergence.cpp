// SPDX-License-Identifier: GPL-3.0-or-later
#include "Convergence.hpp"

#include "verification/errorFloor.hpp"

#include <algorithm>
#include <cmath>

namespace slosh
{

namespace
{

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

Convergence convergenceOf(const ErrorTable& table, const std::string& scheme)
{
    Convergence convergence;
    std::vector<double> errors;
    for (const Row* row : table.rowsOf(scheme))
    {
        if (row->hasError())
        {
            convergence.rows.push_back(row);
            errors.push_back(row->error);
        }
    }
    convergence.floor = errorFloor(errors);
    fit(convergence);
    return convergence;
}

} // namespace slosh
