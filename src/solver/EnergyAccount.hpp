// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "integration/TimeIntegrator.hpp"
#include "integration/stopAtWalls.hpp"
#include "particles/EnergyBudget.hpp"
#include "particles/particleFiles.hpp"
#include "physics/Interactions.hpp"
#include "physics/Rates.hpp"
#include "scene/Scene.hpp"
#include "solver/Walls.hpp"

#include <vector>

namespace slosh
{

/// Adds up the energy budget step by step, each power as the integrators take it: forces and pressures half-way through
/// the step, velocities the mean of its start and end, density rates where the integrator evaluates them, half-way or
/// the mean of both ends. The kinetic energy's change over a step is then the work of these forces to rounding, and
/// what walls take is true where they lose contact between one evaluation and the next. With f the acceleration by
/// pairs, u the velocity relative to the tank, f^v, D^d and f^w, D^w what viscosity, density diffusion and the pressure
/// between liquid and walls add to f and to the density rate, a step dt adds
///   work             dt sum m f . (c' + omega x (r - c)): pairs of liquid cancel
///   viscosity        -dt sum m (f^v . (u + u1)/2 - (p^s/rho^2) D), p^s that of physics/AcousticDamper.hpp
///   densityDiffusion -dt sum m (p/rho^2) D^d
///   walls            -dt sum m (f^w . (u + u1)/2 + (p/rho^2) D^w)
/// and besides, where they happen, what stops at walls and re-initialisations of the density take. A wall particle has
/// no energy of its own: what it takes by its pressure while liquid comes nearer it gives back when the liquid goes.
class EnergyAccount
{
public:
    /// Goes on with the budget of `start`, where it has one; else sums begin there, with the energy of `particles`.
    EnergyAccount(
        const Scene& scene, const Particles& particles, const SolverFrame& frame, const TimeState& start, bool friction
    );

    /// Rates of the state at this stage of the step, with the tank as in `frame`: half-way what forces do, and where
    /// the integrator takes it the density rate.
    void evaluated(
        Stage stage, const Interactions& pairs, const ClusterLists& lists, const TimeIntegrator& integrator,
        const Particles& particles, const Rates& rates, const SolverFrame& frame, Walls& walls
    );
    /// At its end, before particles are stopped at walls.
    void endOfStep(const Particles& particles, const TimeIntegrator& integrator, double dt);
    void stopped(const WallStops& stops, double mass);
    /// The internal energy fell from `before` to `after` [J].
    void reinitialised(double before, double after) { budget_.reinitialisation += before - after; }
    /// Back to the start of the step.
    void undo() { budget_ = before_; }

    const EnergyBudget& budget() const { return budget_; }

private:
    void halfWay(const Particles& particles, const Rates& rates, const SolverFrame& frame);
    void keepDensityRate(const Particles& particles, const Rates& rates);

    const Scene& scene_;
    EnergyBudget budget_, before_;
    double tankPower_ = 0;                           ///< half-way through the step, [W]
    std::vector<double> pressure_, dampingPressure_; ///< p/rho^2 there, and of it what damps sound
    /// A force half-way; `carried`: sum m f . velocity of the tank there, where the solver's v is not relative to it.
    struct Force
    {
        std::vector<Vec> f;
        double carried = 0;
    } viscous_, walls_;
    std::vector<Vec> viscousPart_; ///< f^v, empty without viscosity
    Rates wallPart_;               ///< f^w, D^w
    struct DensityRate
    {
        std::vector<double> all, walls, diffusion;
    } atStart_, atEnd_; ///< of the step; half-way: the second alone
};

} // namespace slosh
