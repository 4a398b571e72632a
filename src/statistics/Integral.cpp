// SPDX-License-Identifier: GPL-3.0-or-later
#include "statistics/Integral.hpp"

#include <algorithm>

namespace slosh
{

Integral::Integral(const TimeSeries& series) : series_(series), sum_(series.size(), 0)
{
    for (std::size_t k = 1; k < series.size(); ++k)
    {
        const long double twiceMean = static_cast<long double>(series.value[k - 1]) + series.value[k];
        sum_[k] = sum_[k - 1] + (static_cast<long double>(series.t[k]) - series.t[k - 1]) * twiceMean / 2;
    }
}

long double Integral::until(double time) const
{
    const double value = series_.at(time);
    const auto next = std::upper_bound(series_.t.begin(), series_.t.end(), time);
    const auto k = static_cast<std::size_t>(next - series_.t.begin()) - 1;
    return sum_[k] +
           (static_cast<long double>(time) - series_.t[k]) * (static_cast<long double>(series_.value[k]) + value) / 2;
}

double Integral::between(double begin, double end) const
{
    return static_cast<double>(until(end) - until(begin));
}

} // namespace slosh
