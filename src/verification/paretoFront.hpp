// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

namespace slosh
{

/// The members that nothing beats in both cost and error: i is on the front where no j has cost_j <= cost_i and
/// error_j <= error_i, one of them less. Indices by rising cost, hence falling error; of equals the first; members
/// whose cost or error is no finite number are left out. Throws CaseError for different lengths.
std::vector<std::size_t> paretoFront(const std::vector<double>& cost, const std::vector<double>& error);

} // namespace slosh
