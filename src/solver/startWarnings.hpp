// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "case/Controls.hpp"
#include "solver/WeaklyCompressible.hpp"

#include <string>
#include <vector>

namespace slosh
{

/// What a case's numbers promise before its first step, for the log; empty in a sound case:
///   c0 < 5 (sqrt(g D) + the greatest speed of the tank's walls): the density is off by (v/c0)^2 > 4 %,
///   a step longer than largestStableCo h/c0 (integration/TimeIntegrator.hpp), adjusted (maxCo) or constant (deltaT).
std::vector<std::string> startWarnings(const SloshingProblem& problem, const Schemes& schemes, const Controls& time);

/// Refuses a step longer than maxCourantNumber h/c0 (solver/Schemes.hpp): CaseError. Such a run need not break, as
/// accelerations shorten the step of adjustTimeStep: it would go on in the noise of its sound.
void requireStableStep(const SloshingProblem& problem, const Schemes& schemes, const Controls& time);

} // namespace slosh
