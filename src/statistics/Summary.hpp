// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

namespace slosh
{

/// Statistics of n values, in their unit. What is undefined is NaN: all but the count of no values, the standard
/// deviation and error of one.
struct Summary
{
    std::size_t count = 0;
    double mean;              ///< m = sum x/n
    double standardDeviation; ///< s = sqrt(sum (x - m)^2/(n - 1))
    double standardError;     ///< of the mean, s/sqrt(n), for values independent of each other
    double highestThird;      ///< mean of the n/3 largest, as a significant wave height; n/3 rounded, at least 1
    double highestTenth;      ///< mean of the n/10 largest; n/10 rounded, at least 1
    double maximum;
};

Summary summarise(std::vector<double> values);

} // namespace slosh
