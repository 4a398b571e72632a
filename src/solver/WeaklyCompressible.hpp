// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "integration/TimeIntegrator.hpp"
#include "neighbours/VerletLists.hpp"
#include "particles/extremes.hpp"
#include "particles/particleFiles.hpp"
#include "physics/AcousticDamper.hpp"
#include "physics/Interactions.hpp"
#include "physics/bodyForceIn.hpp"
#include "scene/Scene.hpp"
#include "solver/EnergyAccount.hpp"
#include "solver/Profile.hpp"
#include "solver/Schemes.hpp"
#include "solver/Walls.hpp"
#include "solver/describe.hpp"
#include "solver/soundness.hpp"
#include "solver/stepLimits.hpp"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace slosh
{

/// The weakly compressible scheme of Cao, Ming & Zhang (2014) in the tank's or the inertial frame: its stages, to be
/// called in the order of a time step.
class WeaklyCompressible : private RightHandSides
{
public:
    /// `wallInTank`: positions of the wall particles in tank coordinates, in the order of particles; `particles` and
    /// `start` as read from a time directory, converted here where their frame is the other one. Throws CaseError where
    /// two liquid particles are in one place.
    WeaklyCompressible(
        const Scene& scene, const Schemes& schemes, Particles particles, const TimeState& start,
        std::vector<Vec> wallInTank
    );
    WeaklyCompressible(const WeaklyCompressible&) = delete; // parts refer to its scene
    WeaklyCompressible& operator=(const WeaklyCompressible&) = delete;

    /// From now on the energy budget is kept, which costs one more sum over pairs a step: that of `start`, where it has
    /// one, goes on; else sums begin at its instant, which is now.
    void keepEnergyBudget(const TimeState& start);

    /// Rebuilds the Verlet lists where the particles' displacements, and a step of `longestStep`, demand it.
    void updateNeighbours(double longestStep);
    /// The next step starts as a restart from the state written now would: with new lists and new rates.
    void startAfresh() { lists_.forget(); }

    /// Moving least squares, where step number `index` is one for it.
    void reinitialiseDensity(long index);

    /// Pressure of the liquid (Tait), pressure and density of the walls (Eqs. 13, 14): the state that sums are of.
    void updatePressure() { updatePressure(frame(Stage::begin)); }
    /// What the step's length depends on: the rates at its start, as far as the integrator needs them.
    void beginStep() { integrator_->begin(*this); }

    /// See solver/stepLimits.hpp; throws UnphysicalRun.
    double stableTimeStep(double maxCo) const;
    /// The acoustic and the viscous limit alone, for a liquid at rest: no step is longer.
    double longestTimeStep(double maxCo) const
    {
        return slosh::longestTimeStep(scene_, integrator_->viscosityFactor(), maxCo);
    }

    /// From `time` to `end`. Throws UnphysicalRun where the new state is not sound (not a number, density off beyond
    /// its limit, particles outside the tank), having restored the old one.
    void step(double time, double end);

    const Rates& rates() const override { return rates_; }
    const Particles& particles() const { return particles_; }
    /// Whole, as a restart needs it.
    TimeState state(double time, long index, double deltaT) const;
    /// For samples: without what the damping of sound remembers.
    TimeState sampledState(double time, long index, double deltaT) const;
    double maxSpeed() const { return extremes_.speed; }                       ///< max |v|, [m/s]
    double maxDensityDeviation() const { return extremes_.densityDeviation; } ///< max |rho/rho0 - 1|
    long rebuilds() const { return lists_.rebuilds(); }                       ///< of the lists
    long evaluations() const { return sums_ / 2; }                            ///< of both rates, or of each one once
    /// Times that a particle had to be stopped at a wall, see integration/stopAtWalls.hpp.
    long stoppedAtWalls() const { return stoppedAtWalls_; }
    long outside() const { return outside_; } ///< particles that have leaked, at the end of the last step
    std::size_t bytes() const
    {
        return particles_.bytes() + lists_.bytes() + pairs_->bytes() + integrator_->bytes() + rates_.bytes();
    }
    /// Where the time goes. The program adds what it does itself.
    Profile& profile() const { return profile_; }

    /// Lines for the log: the specialised pair loop, and what this scene leaves out.
    std::vector<std::string> description() const { return describe(*pairs_, scene_, schemes_, account_.has_value()); }

private:
    Particles& state() override { return particles_; }
    /// Eq. 1, with what it needs of pressures and walls.
    void evaluate(Wanted wanted, Stage stage) override;
    void updatePressure(const SolverFrame& frame);
    /// With the tank as it is at this stage of the step.
    SolverFrame frame(Stage stage) const
    {
        return {schemes_.frame, stage == Stage::begin ? tank_ : stage == Stage::halfWay ? next_.over : next_.end};
    }
    BodyForce bodyForce(const SolverFrame& frame) const { return bodyForceIn(frame, scene_.gravity); }

    /// integration/stopAtWalls.hpp; false: no particle is behind a wall.
    bool stopParticles();
    /// Takes what goes from step to step over the one that has been made.
    void accept(double time, double end);
    /// Back to the state before it.
    void drop();
    void findExtremes();

    Scene scene_;
    Schemes schemes_;
    Particles particles_;
    RigidState tank_;   ///< at the last step that was accepted
    TankStep next_;     ///< of the one that is made
    WallStops stopped_; ///< in it
    std::unique_ptr<Interactions> pairs_;
    VerletLists lists_;
    std::unique_ptr<TimeIntegrator> integrator_;
    Rates rates_;
    Walls walls_;
    std::optional<AcousticDamper> damper_;
    std::optional<EnergyAccount> account_;
    double begin_;              ///< of the case, [s]
    std::vector<Wrench> stops_; ///< as TimeState has them
    Extremes extremes_;
    long sums_ = 0; ///< acceleration and density rate count by themselves
    long stoppedAtWalls_ = 0;
    long outside_ = 0;
    mutable Profile profile_; ///< not of the solver's state
};

} // namespace slosh
