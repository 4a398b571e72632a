// SPDX-License-Identifier: GPL-3.0-or-later
#include "statistics/movingAverage.hpp"

#include "base/CaseError.hpp"
#include "statistics/Integral.hpp"

#include <algorithm>
#include <string>

namespace slosh
{

TimeSeries movingAverage(const TimeSeries& series, double width)
{
    if (!(width >= 0))
    {
        throw CaseError("a moving average over " + std::to_string(width) + " s; expected a width >= 0");
    }
    TimeSeries smooth = series;
    const Integral integral(series);
    for (std::size_t k = 0; k < series.size(); ++k)
    {
        const double t = series.t[k];
        const double half = std::min({width / 2, t - series.t.front(), series.t.back() - t});
        // Rounding must not take the window beyond the record, nor to nothing.
        const double begin = std::max(t - half, series.t.front());
        const double end = std::min(t + half, series.t.back());
        if (begin < end)
        {
            smooth.value[k] = integral.between(begin, end) / (end - begin);
        }
    }
    return smooth;
}

} // namespace slosh
