// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "dictionary/Choice.hpp"
#include "fluid/TaitEquation.hpp"
#include "viscosities/ViscosityChoice.hpp"

#include <string>
#include <vector>

namespace slosh
{

using ViscosityType = Choice<ViscosityChoice (*)(const Dictionary& entries, const TaitEquation& state)>;

/// All viscosities, by their names.
const std::vector<ViscosityType>& viscosityTypes();

/// viscosity { type artificial; alpha 0.03; } of constant/fluidProperties; `walls`, which stands there, too, is
/// FluidProperties'. Throws CaseError: an unknown type or key, a coefficient that is missing or < 0. Those of other
/// types may stand there.
ViscosityChoice readViscosity(const Dictionary& entries, const TaitEquation& state);

/// All entries of constant/fluidProperties.
Keys fluidPropertiesKeys();

/// "artificial, alpha = 0.03"
std::string describe(const ViscosityChoice& viscosity);
bool isNone(const ViscosityChoice& viscosity);

} // namespace slosh
