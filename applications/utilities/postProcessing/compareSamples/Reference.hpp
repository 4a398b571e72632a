// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "case/Case.hpp"
#include "statistics/Quantity.hpp"

#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

namespace slosh
{

/// What samples are held against: a figure that somebody states, or a series of the same quantity.
struct Reference
{
    std::optional<Estimate> figure;                 ///< stated
    std::optional<std::pair<double, double>> range; ///< stated: from, to
    std::optional<TimeSeries> series;
    std::optional<std::pair<TimeSeries, TimeSeries>> band;       ///< lowest and highest of many runs
    double timeStart = -std::numeric_limits<double>::infinity(); ///< of the part of the series that counts, where it is
    double timeEnd = std::numeric_limits<double>::infinity();    ///< not that of the samples, [s]
    std::string source;
};

/// A record of measurements that is not there: the comparison is left out, visibly.
class MissingRecord : public std::runtime_error
{
public:
    using std::runtime_error::runtime_error;
};

/// Reads the sub-dictionary reference of a comparison. Exact solutions are evaluated at the times of `samples`. Throws
/// CaseError; MissingRecord where a measured file is not there.
Reference readReference(const Dictionary& dict, const Case& theCase, const TimeSeries& samples);

/// The sub-dictionary.
Key referenceKey();

} // namespace slosh
