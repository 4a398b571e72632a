// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "integration/TimeIntegrator.hpp"
#include "integration/stopAtWalls.hpp"
#include "motion/BodyForce.hpp"
#include "particles/EnergyBudget.hpp"
#include "particles/particleFiles.hpp"
#include "solver/SloshingProblem.hpp"

namespace slosh
{

/// Adds up the energy budget step by step, each power by the midpoint rule that the integrators are built on: forces
/// and density rates half-way through the step, velocities the mean of its start and end, so that the kinetic energy's
/// change over a step is the work of these forces to rounding. With f the acceleration by pairs, u the velocity
/// relative to the tank, f^v and D^d what viscosity and density diffusion add to f and to the density rate, a step dt
/// adds
///   work             dt sum m f . (c' + omega x (r - c)): pairs of liquid cancel
///   viscosity        -dt sum m f^v . (u + u1)/2
///   densityDiffusion -dt sum m (p/rho^2) D^d,  p and rho of the mean of the densities before and after
///   walls            dt times physics/powerOnWalls.hpp
/// and besides, where they happen, what stops at walls and re-initialisations of the density take.
class EnergyAccount
{
public:
    EnergyAccount(const SloshingProblem& problem, Frame frame, const EnergyBudget& budget);

    /// Half-way through a step, in the state there and the tank's motion over it (SolidBodyMotion::over);
    /// `dissipation`: f^v and D^d, empty where the scene has neither; `powerOnWalls` per metre in 2D, [W/m] or [W].
    void halfWay(const Particles& particles, const Rates& rates, const Rates& dissipation, double powerOnWalls,
                 const RigidState& tank);
    /// At its end, before particles are stopped at walls.
    void endOfStep(const Particles& particles, const TimeIntegrator& integrator, const Rates& dissipation, double dt);
    /// Over a step: `power` of AcousticDamper, [W], in 2D per metre of the empty direction.
    void damped(double power, double dt);
    void stopped(const WallStops& stops, double mass);
    /// The internal energy fell from `before` to `after` [J].
    void reinitialised(double before, double after) { budget_.reinitialisation += before - after; }
    /// Back to the start of the step.
    void undo() { budget_ = before_; }

    const EnergyBudget& budget() const { return budget_; }

private:
    SloshingProblem problem_;
    Frame frame_;
    EnergyBudget budget_, before_;
    // Powers half-way through the step, [W].
    double tankPower_ = 0, wallPower_ = 0;
    double carriedViscousPower_ = 0; ///< sum m f^v . velocity of the tank there, where the solver's v is not relative
};

} // namespace slosh
