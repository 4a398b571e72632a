// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "case/Controls.hpp"
#include "scene/Scene.hpp"
#include "solver/Schemes.hpp"

namespace slosh
{

/// The longest step at which walls give liquid that leaves them less than about 1 % of m g D, as measured with c0 of 60
/// to 400 times the flow's speed (docs/decisions/0018-energy-budget.md):
///   maxCo = 8 c/c0 where c0 > 10 c,
/// c the speed of sound 'auto', ten times the speed that depth and motion promise. Infinite elsewhere and without
/// gravity, where nothing is measured.
double maxCoOfStiffLiquid(const Scene& scene);

/// Refuses a step longer than maxCourantNumber h/c0 (solver/Schemes.hpp): CaseError. Such a run need not break, as
/// accelerations shorten the step of adjustTimeStep: it would go on in the noise of its sound.
void requireStableStep(const Scene& scene, const Schemes& schemes, const Controls& time);

} // namespace slosh
