// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Vec.hpp"

#include <variant>
#include <vector>

namespace slosh
{

/// The values of a field: scalars, vectors or labels.
using FieldValues = std::variant<std::vector<double>, std::vector<Vec>, std::vector<int>>;

} // namespace slosh
