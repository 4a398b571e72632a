// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/WeaklyCompressible.hpp"

#include "base/parallel.hpp"
#include "integration/stopAtWalls.hpp"
#include "particles/liquidEnergies.hpp"
#include "physics/meanDiffusion.hpp"
#include "solver/leftOut.hpp"
#include "solver/partsOf.hpp"
#include "solver/startParticles.hpp"
#include "solver/stepLimits.hpp"

namespace slosh
{

WeaklyCompressible::WeaklyCompressible(
    const Scene& scene, const Schemes& schemes, Particles particles, const TimeState& start, std::vector<Vec> wallInTank
)
    : scene_(scene), schemes_(schemes),
      particles_(startParticles(scene, schemes, std::move(particles), start, wallInTank)),
      pairs_(interactionsOf(scene, schemes)), integrator_(TimeIntegrator::make(schemes.timeIntegration)),
      walls_(scene_, particles_, std::move(wallInTank), {schemes.frame, start.tank}, schemes.soundDamping > 0),
      damper_(soundDamper(scene, schemes, particles_.spacing, start.sound)), begin_(start.begin)
{
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
    const double support = scene_.kernel.supportRadius();
    if (lists_.update(
            particles_, support, pairs_->lanes(), schemes_.frame == Frame::inertial, longestStep, extremes_.speed
        ))
    {
        pairs_->listBuilt(particles_, lists_.list(), support + lists_.largestSkin());
        walls_.listBuilt(particles_, scene_.equationOfState.rho0, lists_.largestSkin());
        integrator_->forget(); // the particles stand in another order
    }
}

void WeaklyCompressible::reinitialiseDensity(double time, long index)
{
    if (schemes_.densityInterval == 0 || index == 0 || index % schemes_.densityInterval != 0)
    {
        return;
    }
    updatePressure(time);
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
    const auto section = profile_.section(Work::rightHandSides);
    parallelFor(
        particles_.nFluid, [&](std::ptrdiff_t i) { particles_.p[i] = scene_.equationOfState.p(particles_.rho[i]); }
    );
    if (damper_)
    {
        damper_->addTo(particles_, frame);
    }
    const auto walls = profile_.section(Work::walls);
    const bool wallsHaveMoved = walls_.move(frame, particles_);
    pairs_->see(
        lists_.list(), wallsHaveMoved, bodyForce(frame), scene_.equationOfState, scene_.wallSuction, particles_,
        walls_.contact()
    );
}

void WeaklyCompressible::evaluate(Wanted wanted, const SolverFrame& frame)
{
    sums_ += wanted == Wanted::both ? 2 : 1;
    updatePressure(frame);
    const auto section = profile_.section(Work::rightHandSides);
    pairs_->rates(wanted, lists_.list(), particles_, bodyForce(frame), rates_);
    if (wanted != Wanted::densityRate)
    {
        walls_.addFriction(particles_, frame, rates_.acceleration);
    }
}

void WeaklyCompressible::evaluate(Wanted wanted, double time)
{
    evaluate(wanted, frameAt(time));
    if (account_ && !integrator_->takesDensityRateHalfWay())
    {
        const auto section = profile_.section(Work::energyBudget);
        account_->densityRateFound(*pairs_, lists_.list(), particles_, rates_);
    }
}

void WeaklyCompressible::evaluateHalfWay(Wanted wanted, double begin, double end)
{
    const SolverFrame frame(schemes_.frame, scene_.motion->over(begin, end));
    evaluate(wanted, frame);
    if (account_)
    {
        const auto section = profile_.section(Work::energyBudget);
        account_->halfWay(*pairs_, lists_.list(), *integrator_, particles_, rates_, frame, walls_);
    }
}

double WeaklyCompressible::longestTimeStep(double maxCo) const
{
    return slosh::longestTimeStep(scene_, integrator_->viscosityFactor(), maxCo);
}

double WeaklyCompressible::stableTimeStep(double maxCo) const
{
    const auto section = profile_.section(Work::timeStep);
    return slosh::stableTimeStep(scene_, particles_, rates_, extremes_.speed, integrator_->viscosityFactor(), maxCo);
}

void WeaklyCompressible::step(double time, double end)
{
    const auto section = profile_.section(Work::integration);
    integrator_->step(*this, time, end - time);
    if (account_)
    {
        const auto budget = profile_.section(Work::energyBudget);
        account_->endOfStep(particles_, *integrator_, end - time);
    }
    const SolverFrame frame = frameAt(end);
    const bool someBehindWalls = stopParticles(frame);
    findExtremes();
    const Soundness found = soundness(particles_, extremes_, scene_, schemes_, frame, someBehindWalls);
    outside_ = found.outside;
    if (!found.fault.empty())
    {
        drop();
        throw UnphysicalRun(found.fault);
    }
    accept(frame, time, end);
}

bool WeaklyCompressible::stopParticles(const SolverFrame& frame)
{
    if (particles_.nWall == 0)
    {
        return true; // not checked
    }
    const WallStops stops = stopAtWalls(scene_.tank, frame, scene_.equationOfState, particles_);
    stoppedAtWalls_ += stops.particles;
    if (stops.particles > 0)
    {
        integrator_->forget(); // its rates are of the state before the stop
    }
    if (account_)
    {
        account_->stopped(stops, particles_.mass);
    }
    return stops.behind > 0;
}

void WeaklyCompressible::accept(const SolverFrame& frame, double time, double end)
{
    if (damper_)
    {
        damper_->update(particles_, frame, rates_);
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
    TimeState state{time, index, deltaT, schemes_.frame, scene_.motion->at(time)};
    state.begin = begin_;
    if (account_)
    {
        state.budget = account_->budget();
    }
    return state;
}

TimeState WeaklyCompressible::state(double time, long index, double deltaT) const
{
    TimeState state = sampledState(time, index, deltaT);
    if (damper_)
    {
        state.sound = damper_->state();
    }
    return state;
}

std::vector<std::string> WeaklyCompressible::description() const
{
    std::vector<std::string> lines = {"pair loop: " + pairs_->description()};
    for (const std::string& part : leftOut(scene_, schemes_, account_.has_value()))
    {
        lines.push_back("left out: " + part);
    }
    return lines;
}

} // namespace slosh
