// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/CaseError.hpp"
#include "particles/extremes.hpp"
#include "scene/Scene.hpp"
#include "solver/Schemes.hpp"

#include <string>

namespace slosh
{

/// A run that has become unphysical: what, where, when and what to change. The solver has gone back to the last good
/// state.
class UnphysicalRun : public CaseError
{
public:
    using CaseError::CaseError;
};

struct Soundness
{
    std::string fault; ///< what is wrong, where, and what may help; "" in a sound state
    long outside = 0;  ///< particles that have leaked
};

/// Whether a state keeps the bounds of `schemes` (limits): numbers that are numbers, |rho/rho0 - 1|, particles outside
/// the tank. They are looked for where `someBehindWalls`.
Soundness soundness(
    const Particles& particles, const Extremes& extremes, const Scene& scene, const Schemes& schemes,
    const SolverFrame& frame, bool someBehindWalls
);

} // namespace slosh
