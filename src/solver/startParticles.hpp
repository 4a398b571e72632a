// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "particles/particleFiles.hpp"
#include "scene/Scene.hpp"
#include "solver/Schemes.hpp"

namespace slosh
{

/// The particles that a run begins with: those read from a time directory with `start`, in the scheme's frame, with the
/// fields that its terms remember. Walls in the tank's frame stand where `wallInTank` says, to the bit. Throws
/// CaseError where two liquid particles are in one place.
Particles startParticles(
    const Scene& scene, const Schemes& schemes, Particles particles, const TimeState& start,
    const std::vector<Vec>& wallInTank
);

} // namespace slosh
