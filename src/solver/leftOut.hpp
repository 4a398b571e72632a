// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/Scene.hpp"
#include "solver/Schemes.hpp"

#include <string>
#include <vector>

namespace slosh
{

/// What a run of this scene does not compute, as it does not need it.
std::vector<std::string> leftOut(const Scene& scene, const Schemes& schemes, bool keepsBudget);

} // namespace slosh
