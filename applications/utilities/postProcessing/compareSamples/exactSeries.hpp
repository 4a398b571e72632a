// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "case/Case.hpp"
#include "dictionary/Choice.hpp"
#include "statistics/TimeSeries.hpp"

namespace slosh
{

/// An exact solution at the times of `samples`. It reads what it needs of the case: tank, gravity, density, motion.
/// Throws CaseError.
using ExactSeries = Choice<TimeSeries (*)(const Dictionary& dict, const Case& theCase, const TimeSeries& samples)>;

const std::vector<ExactSeries>& exactSeries();

} // namespace slosh
