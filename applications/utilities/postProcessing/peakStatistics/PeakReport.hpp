// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "PeakQuery.hpp"

#include "statistics/peaks.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace slosh
{

/// A named number and, where it is an estimate, its confidence bounds; else these are NaN.
struct Figure
{
    std::string name;
    double value, low, high;
};

/// The peaks of a query and the figures drawn from them.
struct PeakReport
{
    PeakQuery query;
    std::vector<Peak> peaks;
    std::vector<std::vector<double>> means; ///< for each of the query's windows largestMeansAround() the peaks
    std::vector<Figure> figures;            ///< those that exist: no mean of no peaks, no deviation of one
    std::string remark;                     ///< why there are no peaks or no Weibull fit, or ""

    std::string peaksText() const;      ///< peaks.dat
    std::string statisticsText() const; ///< statistics.dat, which is also printed
};

/// Reads the samples below `postProcessing`, smooths them, finds the peaks between the times asked for and draws the
/// figures from them. Throws CaseError, with the place of the query: no samples, no such column, none between the
/// times.
PeakReport reportPeaks(const std::filesystem::path& postProcessing, const PeakQuery& query);

} // namespace slosh
