// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "case/Controls.hpp"
#include "particles/particleFiles.hpp"
#include "scene/Scene.hpp"
#include "solver/Schemes.hpp"

#include <string>
#include <vector>

namespace slosh
{

/// What a case promises before its first step, for the log; empty in a sound case:
///   c0 < 5 (sqrt(g D) + the greatest speed of the tank's walls): the density is off by (v/c0)^2 > 4 %,
///   a time directory that says another time than its name, or a tank that does not go on from there, as the motion was
///   changed,
///   a maxCo that maxCoOfStiffLiquid() (solver/stepLimits.hpp) has shortened, or one of the case's own beyond it,
///   a step longer than largestStableCo h/c0 (integration/TimeIntegrator.hpp), adjusted (maxCo) or constant (deltaT).
std::vector<std::string>
startWarnings(const Scene& scene, const Schemes& schemes, const Controls& time, const TimeState& start);

} // namespace slosh
