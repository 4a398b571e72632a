// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace slosh
{

/// Where errors stop falling: the first i for which errors[i + 1] and errors[i + 2], of two successive refinements,
/// are each more than 0.9 of the one before. Nothing where there is none.
std::optional<std::size_t> errorFloor(const std::vector<double>& errors);

} // namespace slosh
