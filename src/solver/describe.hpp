// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "physics/Interactions.hpp"
#include "scene/Scene.hpp"
#include "solver/Schemes.hpp"

#include <string>
#include <vector>

namespace slosh
{

/// Lines for the log: the pair loop, "left out: " what a run of this scene does not compute, as it does not need it.
std::vector<std::string>
describe(const Interactions& pairs, const Scene& scene, const Schemes& schemes, bool keepsBudget);

} // namespace slosh
