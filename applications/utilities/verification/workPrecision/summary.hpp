// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ErrorTable.hpp"
#include "Study.hpp"

namespace slosh
{

/// What the tables say, in words: which setting reaches each target at what cost, what spacing and CPU time a target
/// needs by the fitted powers of the spacing, observed orders and grid convergence indices, where an error stops
/// falling and what moves it there, which runs have failed.
std::string summaryText(const Study& study, const std::vector<Run>& runs, const std::vector<ErrorTable>& tables);

} // namespace slosh
