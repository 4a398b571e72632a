// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ErrorTable.hpp"

namespace slosh
{

// All runs in all comparisons, one row each; what is unknown is nan. Columns: case, particleSpacing [m], scheme, error
// (a share unless the quantity is an instant, a ratio or a range), cpuSeconds, wallSeconds, steps, evaluations,
// particles (liquid), peakMemoryMB, observedOrder (to the next coarser run), figure, comparison, run, status
// (finished | failed).

std::string csvText(const std::string& caseName, const std::vector<ErrorTable>& tables);
/// The same, aligned by blanks.
std::string alignedText(const std::string& caseName, const std::vector<ErrorTable>& tables);

} // namespace slosh
