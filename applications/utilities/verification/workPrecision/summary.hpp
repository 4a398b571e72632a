// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ErrorTable.hpp"
#include "Study.hpp"

namespace slosh
{

/// What the tables say, in words: which setting reaches each target at what cost, what spacing and CPU time a target
/// needs by the fitted powers of the spacing, where an error stops falling and what moves it there, the order of each
/// figure, its limit and the parts of its uncertainty, which runs have failed; at the end a sentence for each figure.
std::string summaryText(const Study& study, const std::vector<Run>& runs, const std::vector<ErrorTable>& tables);

} // namespace slosh
