// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "case/Controls.hpp"
#include "particles/Particles.hpp"
#include "physics/Rates.hpp"
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

/// What bounds the viscous step, [m^2/s]: the viscosity's kinematic(), nu times `factor`
/// (TimeIntegrator::viscosityFactor()), or what the artificial one would act like over all pairs, about twice what
/// approaching pairs alone do.
double kinematicViscosity(const Scene& scene, double factor);

/// The acoustic and the viscous limit alone, for a liquid at rest: no step is longer, [s].
double longestTimeStep(const Scene& scene, double viscosityFactor, double maxCo);

/// The longest stable step of integration/timeStep.hpp, [s]. Throws UnphysicalRun where it has fallen below a
/// thousandth of longestTimeStep().
double stableTimeStep(
    const Scene& scene, const Particles& particles, const Rates& rates, double maxSpeed, double viscosityFactor,
    double maxCo
);

/// Refuses a step longer than maxCourantNumber h/c0 (solver/Schemes.hpp): CaseError. Such a run need not break, as
/// accelerations shorten the step of adjustTimeStep: it would go on in the noise of its sound.
void requireStableStep(const Scene& scene, const Schemes& schemes, const Controls& time);

} // namespace slosh
