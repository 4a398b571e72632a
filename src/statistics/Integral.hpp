// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "statistics/TimeSeries.hpp"

#include <vector>

namespace slosh
{

/// The integral over time of a series, linear between its samples: exact for any spacing, by the trapezoidal rule over
/// whole intervals and the parts at both ends. Keeps a reference to the series.
class Integral
{
public:
    explicit Integral(const TimeSeries& series);
    Integral(TimeSeries&&) = delete;

    /// int_begin^end value dt, in the unit of the samples times s. Both within the record; CaseError otherwise.
    double between(double begin, double end) const;

    const TimeSeries& series() const { return series_; }

private:
    long double until(double time) const;

    const TimeSeries& series_;
    // A short window late in a long record is the small difference of two large sums.
    std::vector<long double> sum_; ///< from the first sample to each
};

} // namespace slosh
