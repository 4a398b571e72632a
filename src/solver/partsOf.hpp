// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "physics/AcousticDamper.hpp"
#include "physics/Interactions.hpp"
#include "scene/Scene.hpp"
#include "solver/Schemes.hpp"

#include <memory>
#include <optional>
#include <vector>

namespace slosh
{

// The parts of a solver that a scene and its schemes call for.

std::unique_ptr<Interactions> interactionsOf(const Scene& scene, const Schemes& schemes);

/// None where the schemes have no soundDamping; `state`: that of a run that goes on.
std::optional<AcousticDamper>
soundDamper(const Scene& scene, const Schemes& schemes, double particleSpacing, const std::vector<double>& state);

} // namespace slosh
