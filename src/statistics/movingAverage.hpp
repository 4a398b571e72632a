// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "statistics/TimeSeries.hpp"

namespace slosh
{

/// The mean of a series, linear between its samples, over a window of `width` [s] centred on each sample:
///     p_k = 1/(2 w) int_{t_k - w}^{t_k + w} p dt,   w = min(width/2, t_k - t_first, t_last - t_k)
/// The integral is exact for any spacing of the samples. Near both ends of the record the window shrinks and stays
/// centred, so that nothing is shifted in time: a straight line stays itself, the first and last sample are kept. Width
/// 0 leaves all as it is. A sine of angular frequency omega is damped by sin(omega width/2)/(omega width/2). Throws
/// CaseError for a width that is negative or no number.
TimeSeries movingAverage(const TimeSeries& series, double width);

} // namespace slosh
