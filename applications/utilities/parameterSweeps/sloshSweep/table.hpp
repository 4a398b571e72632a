// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "CaseState.hpp"

namespace slosh
{

/// A row for each case in the order of their numbers, cells separated by tabs, under a line of names with units:
/// number, the value of each axis, omega of the motion, first natural frequency, each result (with its uncertainty and
/// its reference where it has them), CPU seconds, status, reason. What is not known is nan.
std::string tableText(const Sweep& sweep, const std::vector<CaseState>& states);

/// What -dry-run shows: the same without the results, in aligned columns.
std::string casesText(const Sweep& sweep, const std::vector<CaseState>& states);

} // namespace slosh
