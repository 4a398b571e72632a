// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "case/Controls.hpp"
#include "solver/WeaklyCompressible.hpp"

#include <string>
#include <vector>

namespace slosh
{

/// The longest step at which walls give liquid that leaves them less than about 1 % of m g D, as measured with c0 of 60
/// to 400 times the flow's speed (docs/decisions/0018-energy-budget.md):
///   maxCo = 8 c/c0 where c0 > 10 c,
/// c the speed of sound 'auto', ten times the speed that depth and motion promise. Infinite elsewhere and without
/// gravity, where nothing is measured.
double maxCoOfStiffLiquid(const SloshingProblem& problem);

/// What a case's numbers promise before its first step, for the log; empty in a sound case:
///   c0 < 5 (sqrt(g D) + the greatest speed of the tank's walls): the density is off by (v/c0)^2 > 4 %,
///   a maxCo that maxCoOfStiffLiquid() has shortened, or one of the case's own beyond it,
///   a step longer than largestStableCo h/c0 (integration/TimeIntegrator.hpp), adjusted (maxCo) or constant (deltaT).
std::vector<std::string> startWarnings(const SloshingProblem& problem, const Schemes& schemes, const Controls& time);

/// Refuses a step longer than maxCourantNumber h/c0 (solver/Schemes.hpp): CaseError. Such a run need not break, as
/// accelerations shorten the step of adjustTimeStep: it would go on in the noise of its sound.
void requireStableStep(const SloshingProblem& problem, const Schemes& schemes, const Controls& time);

} // namespace slosh
