// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "case/Case.hpp"

#include <string>
#include <vector>

namespace slosh
{

/// Warns of turbulence models, sources, constraints and rotating frames, which are not used. Throws CaseError for a
/// source that drives the liquid by the tank's acceleration: without it the liquid would rest.
void warnOfModels(const Case& from, std::vector<std::string>& warnings);

} // namespace slosh
