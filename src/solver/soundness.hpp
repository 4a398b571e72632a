// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "particles/extremes.hpp"
#include "scene/Scene.hpp"
#include "solver/Schemes.hpp"

#include <string>

namespace slosh
{

struct Soundness
{
    std::string fault; ///< what is wrong, where, and what may help; "" in a sound state
    long outside = 0;  ///< particles that have leaked
};

/// Whether a state keeps the bounds of `schemes` (limits): numbers that are numbers, |rho/rho0 - 1|, particles outside
/// the tank. They are looked for where `someBehindWalls`.
Soundness soundness(const Particles& particles, const Extremes& extremes, const Scene& scene, const Schemes& schemes,
                    const SolverFrame& frame, bool someBehindWalls);

} // namespace slosh
