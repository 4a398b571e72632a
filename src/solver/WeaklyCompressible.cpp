// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/WeaklyCompressible.hpp"

#include "particles/liquidEnergies.hpp"
#include "physics/loadByMomentum.hpp"
#include "physics/meanDiffusion.hpp"
#include "solver/partsOf.hpp"
#include "solver/startParticles.hpp"

namespace slosh
{

WeaklyCompressible::WeaklyCompressible(
    const Scene& scene, const Schemes& schemes, Particles particles, const TimeState& start, std::vector<Vec> wallInTank
)
    : scene_(scene), schemes_(schemes),
      particles_(startParticles(scene, schemes, std::move(particles), start, wallInTank)),
      tank_(scene.motion->advance(start.tank, start.time, start.time, {}).end), pairs_(interactionsOf(scene, schemes)),
      lists_(scene.tank.directions(), scene.kernel.supportRadius()),
      integrator_(TimeIntegrator::make(schemes.timeIntegration)),
      walls_(scene_, particles_, std::move(wallInTank), {schemes.frame, start.tank}, schemes.soundDamping > 0),
      damper_(soundDamper(scene, schemes, particles_.spacing, start.sound)), begin_(start.begin), stops_(start.stops)
{
    start.requireStopsOn(scene.tank.parts());
    if (damper_)
    {
        damper_->findEnclosed(walls_.inTank(), walls_.contact());
    }
    rates_.resize(particles_.nFluid);
    findExtremes();
}

void WeaklyCompressible::keepEnergyBudget(const TimeState& start)
{
    account_.emplace(scene_, particles_, SolverFrame(schemes_.frame, start.tank), start, walls_.haveFriction());
}

void WeaklyCompressible::updateNeighbours(double longestStep)
{
    const auto section = profile_.section(Work::lists);
    if (lists_.update(particles_, schemes_.frame == Frame::inertial, longestStep, extremes_.speed))
    {
        pairs_->listBuilt(particles_, lists_.list(), scene_.kernel.supportRadius() + lists_.largestSkin());
        walls_.listBuilt(particles_, scene_.equationOfState.rho0, lists_.largestSkin());
        integrator_->forget(); // the particles stand in another order
    }
}

void WeaklyCompressible::reinitialiseDensity(long index)
{
    if (schemes_.densityInterval == 0 || index == 0 || index % schemes_.densityInterval != 0)
    {
        return;
    }
    updatePressure();
    const auto section = profile_.section(Work::density);
    const auto energy = [this] { return internalEnergy(particles_, scene_.equationOfState, scene_.tank.thickness()); };
    const double before = account_ ? energy() : 0;
    pairs_->movingLeastSquares(lists_.list(), particles_, particles_.rho);
    if (account_)
    {
        account_->reinitialised(before, energy());
    }
    integrator_->forget();
}

void WeaklyCompressible::updatePressure(const SolverFrame& frame)
{
    const auto section = profile_.section(Work::walls);
    if (walls_.move(frame, particles_))
    {
        pairs_->wallsMoved(particles_, lists_.list());
    }
    // A copy: compilers cannot know that the pressures, which are written, are not among its members.
    const auto setPressure = [&, tait = scene_.equationOfState](std::ptrdiff_t begin, std::ptrdiff_t end)
    {
        for (std::ptrdiff_t i = begin; i < end; ++i)
        {
            particles_.p[i] = tait.p(particles_.rho[i]);
        }
        for (std::ptrdiff_t i = begin; damper_ && i < end; ++i)
        {
            particles_.p[i] += damper_->pressure(frame.toTank(particles_.r[i]));
        }
    };
    pairs_->see(
        lists_.list(), {bodyForce(frame), scene_.equationOfState, scene_.wallSuction}, setPressure, particles_,
        walls_.contact()
    );
}

void WeaklyCompressible::evaluate(Wanted wanted, Stage stage)
{
    sums_ += wanted == Wanted::both ? 2 : 1;
    const SolverFrame frame = this->frame(stage);
    updatePressure(frame);
    {
        const auto section = profile_.section(Work::rightHandSides);
        pairs_->rates(wanted, lists_.list(), particles_, bodyForce(frame), rates_);
        if (wanted != Wanted::densityRate)
        {
            walls_.addFriction(particles_, frame, rates_.acceleration);
        }
    }
    if (account_)
    {
        const auto section = profile_.section(Work::energyBudget);
        account_->evaluated(stage, *pairs_, lists_.list(), *integrator_, particles_, rates_, frame, walls_);
    }
}

double WeaklyCompressible::stableTimeStep(double maxCo) const
{
    const auto section = profile_.section(Work::timeStep);
    return slosh::stableTimeStep(scene_, particles_, rates_, extremes_.speed, integrator_->viscosityFactor(), maxCo);
}

void WeaklyCompressible::step(double time, double end)
{
    const auto section = profile_.section(Work::integration);
    // By the accelerations that were summed last: at the start or, with position Verlet, half-way in the step before.
    const Wrench load =
        scene_.motion->isMovedByLoad()
            ? loadByMomentum(particles_, rates_.acceleration, frame(Stage::begin), scene_.gravity, scene_.tank)
            : Wrench();
    next_ = scene_.motion->advance(tank_, time, end, load);
    integrator_->step(*this, end - time);
    if (account_)
    {
        const auto budget = profile_.section(Work::energyBudget);
        account_->endOfStep(particles_, *integrator_, end - time);
    }
    const bool someBehindWalls = particles_.nWall == 0 || stopParticles(); // without walls: not checked
    findExtremes();
    const Soundness found = soundness(particles_, extremes_, scene_, schemes_, frame(Stage::end), someBehindWalls);
    outside_ = found.outside;
    if (!found.fault.empty())
    {
        drop();
        throw UnphysicalRun(found.fault);
    }
    accept(time, end);
}

bool WeaklyCompressible::stopParticles()
{
    stopped_ = stopAtWalls(scene_.tank, frame(Stage::end), scene_.equationOfState, particles_);
    if (stopped_.particles > 0)
    {
        integrator_->forget(); // its rates are of the state before the stop
    }
    if (account_)
    {
        account_->stopped(stopped_, particles_.mass);
    }
    return stopped_.behind > 0;
}

void WeaklyCompressible::accept(double time, double end)
{
    tank_ = next_.end;
    stoppedAtWalls_ += stopped_.particles;
    addImpulses(stopped_, particles_.mass * scene_.tank.thickness(), stops_);
    if (damper_)
    {
        damper_->update(particles_, frame(Stage::end), rates_);
        damper_->findEnclosed(walls_.inTank(), walls_.contact());
    }
    advanceMeanDiffusion(
        particles_, rates_, scene_.kernel.smoothingLength(), scene_.equationOfState.c0, end - begin_, end - time
    );
    walls_.advance(particles_, end - time);
}

void WeaklyCompressible::drop()
{
    integrator_->restore(particles_);
    if (account_)
    {
        account_->undo();
    }
    findExtremes();
}

void WeaklyCompressible::findExtremes()
{
    const auto section = profile_.section(Work::timeStep);
    extremes_ = extremes(particles_, scene_.equationOfState.rho0);
}

TimeState WeaklyCompressible::sampledState(double time, long index, double deltaT) const
{
    const auto budget = account_ ? std::optional(account_->budget()) : std::nullopt;
    return {time, index, deltaT, schemes_.frame, tank_, budget, begin_, stops_};
}

TimeState WeaklyCompressible::state(double time, long index, double deltaT) const
{
    TimeState state = sampledState(time, index, deltaT);
    state.sound = damper_ ? damper_->state() : std::vector<double>();
    return state;
}

} // namespace slosh
