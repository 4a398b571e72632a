// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ExtrudedTank.hpp"

#include "dictionary/Dictionary.hpp"

#include <string>
#include <vector>

namespace slosh
{

/// What samples in `controlDict` as ours does: probes of p and wave gauges (interfaceHeight), their points inside the
/// tank. `timeStep` becomes runTime, by their deltaT: ours is far shorter. Told in `warnings`: what is left out.
Dictionary
convertFunctions(const Dictionary& controlDict, const ExtrudedTank& tank, std::vector<std::string>& warnings);

} // namespace slosh
