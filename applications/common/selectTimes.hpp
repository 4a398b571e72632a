// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "case/Case.hpp"
#include "common/Program.hpp"

#include <vector>

namespace slosh
{

/// Adds OpenFOAM's -time <ranges>, -latestTime and -noZero.
void addTimeOptions(Program& program);

/// The times of the case that those options choose, sorted; all without them. Ranges as OpenFOAM takes them, separated
/// by commas or blanks: 0.5:2 (both ends included), :3, 5:, and a single value, which stands for the time nearest to
/// it. Throws CaseError: a malformed range, or no time chosen.
std::vector<TimeDirectory> selectTimes(const Case& theCase, const Program& program);

} // namespace slosh
