// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "dictionary/Dictionary.hpp"

#include <limits>
#include <string>
#include <vector>

namespace slosh
{

/// What one entry of system/peakStatisticsDict asks for; values are in the unit of the samples.
struct PeakQuery
{
    std::string name;
    std::string place;   ///< " in system/peakStatisticsDict at line 10", for messages
    std::string samples; ///< below postProcessing/, without the start time: pressure/p
    int column = 0;      ///< 0 is the time
    double timeStart = -std::numeric_limits<double>::infinity(); ///< [s]
    double timeEnd = std::numeric_limits<double>::infinity();    ///< [s]
    double filter = 0;                                           ///< width of the moving average, [s]
    double threshold = 0;
    double separation = 0;          ///< [s]
    std::vector<double> windows;    ///< of the largest means beside the peaks, [s]
    double location = 0;            ///< of the Weibull distribution
    std::vector<double> exceedance; ///< probabilities
    double confidence = 0;
};

/// All entries of the dictionary. Throws CaseError: there is none, one is named so that it cannot name a folder, a key
/// is missing or unknown, a value out of its range.
std::vector<PeakQuery> readPeakQueries(const Dictionary& dict);

/// All entries of system/peakStatisticsDict.
Keys peakStatisticsDictKeys();

} // namespace slosh
