// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Runs that must have the same bits.
#include "CaseDirectory.hpp"

#include <string>

namespace slosh
{

/// Every field of both clouds, and what stands in uniform/, at one time.
void expectSameState(const CaseDirectory& a, const CaseDirectory& b, const std::string& time);

/// A case that is stopped half-way, at 0.05 s, and goes on has the state and the samples of one that is not; `threads`:
/// of the second half.
void expectRestartContinuesBitForBit(const CaseDirectory& whole, const std::string& threads);

} // namespace slosh
