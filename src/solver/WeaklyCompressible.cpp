// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/WeaklyCompressible.hpp"

#include "base/parallel.hpp"
#include "base/pointText.hpp"
#include "integration/stopAtWalls.hpp"
#include "integration/timeStep.hpp"
#include "neighbours/coincident.hpp"
#include "neighbours/sortByCell.hpp"
#include "particles/changeFrame.hpp"
#include "particles/liquidEnergies.hpp"
#include "solver/makeInteractions.hpp"
#include "solver/soundness.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace slosh
{

namespace
{

PairGeometry pairGeometry(const Tank& tank, const Kernel& kernel)
{
    PairGeometry geometry;
    geometry.dim = tank.dim();
    for (std::size_t d = 0; d < tank.directions().size(); ++d)
    {
        geometry.directions[d] = tank.directions()[d];
    }
    geometry.smoothingLength = kernel.smoothingLength();
    return geometry;
}

} // namespace

WeaklyCompressible::WeaklyCompressible(const SloshingProblem& problem, const Schemes& schemes, Particles particles,
                                       const TimeState& start, std::vector<Vec> wallInTank)
    : problem_(problem), schemes_(schemes), particles_(std::move(particles)), wallInTank_(std::move(wallInTank)),
      interactions_(makeInteractions(
          pairGeometry(problem.tank, problem.kernel), problem.kernel.choice(),
          {chooseViscosity(problem.fluid, problem.equationOfState, problem.kernel.smoothingLength()),
           chooseDensityDiffusion(schemes.densityDiffusion, problem.equationOfState), problem.fluid.slip},
          schemes.precision)),
      integrator_(TimeIntegrator::make(schemes.timeIntegration))
{
    // In any frame: nearer than rounding puts them.
    if (const auto pair = coincident(particles_, 1e-6 * particles_.spacing))
    {
        const auto [a, b] = *pair;
        throw CaseError("the particles " + std::to_string(particles_.id[a]) + " and " +
                            std::to_string(particles_.id[b]) + " are in the same place, " + text(particles_.r[a]) +
                            ": they would never part; regions of liquid or files that were edited must not put two "
                            "particles into one",
                        CaseError::Kind::input);
    }
    changeFrame(particles_, start.tank, start.frame, schemes_.frame);
    if (schemes_.frame == Frame::tank)
    {
        std::copy(wallInTank_.begin(), wallInTank_.end(), particles_.r.begin() + particles_.nFluid);
        std::fill(particles_.v.begin() + particles_.nFluid, particles_.v.end(), Vec::Zero());
    }
    moveWalls(start.tank);
    if (problem_.fluid.friction.boundaryLayers)
    {
        friction_.emplace(problem_.fluid, problem_.tank, particles_.spacing,
                          problem_.fluid.sideWallDrag(problem_.tank, problem_.gravity), wallInTank_, start.layers);
    }
    contact_.resize(friction_ || schemes_.soundDamping > 0 ? wallInTank_.size() : 0);
    if (schemes_.soundDamping > 0)
    {
        const double L = schemes_.dampingLength > 0 ? schemes_.dampingLength
                                                    : AcousticDamper::length(problem_.tank, particles_.spacing);
        damper_.emplace(problem_.tank, L, schemes_.soundDamping * L * problem_.equationOfState.c0,
                        problem_.equationOfState.rho0, start.sound);
        damper_->findEnclosed(wallInTank_, contact_);
    }
    rates_.resize(particles_.nFluid);
    particles_.meanDiffusion.resize(schemes_.densityDiffusion == 0 ? 0 : particles_.nFluid);
    begin_ = start.begin;
    findExtremes();
}

void WeaklyCompressible::moveWalls(const RigidState& tank)
{
    if (schemes_.frame == Frame::tank)
    {
        return;
    }
    parallelFor(particles_.nWall,
                [&](std::ptrdiff_t k)
                {
                    const Vec& X = wallInTank_[k];
                    const std::ptrdiff_t i = particles_.nFluid + k;
                    particles_.r[i] = tank.pointToInertial(X);
                    particles_.v[i] = tank.velocityAt(X);
                });
}

BodyForce WeaklyCompressible::bodyForce(const RigidState& tank) const
{
    return bodyForceIn(schemes_.frame, problem_.gravity, tank);
}

void WeaklyCompressible::updateNeighbours(double longestStep)
{
    const auto section = profile_.section(Work::lists);
    if (!skin_.mustRebuild(particles_, longestStep, extremes_.speed))
    {
        return;
    }
    const double support = problem_.kernel.supportRadius();
    sortByCell(particles_, support); // not by the reach: where particles stand shall be a function of them alone
    skin_.choose(particles_, schemes_.frame == Frame::inertial, support, longestStep);
    neighbours_.build(particles_, support, skin_.skins(), interactions_->lanes());
    interactions_->listBuilt(particles_, neighbours_, support + skin_.largest());
    skin_.listBuilt(particles_);
    integrator_->forget(); // the particles stand in another order
    ++rebuilds_;
    // Walls that have no liquid in reach keep this state until the next list.
    std::fill(particles_.p.begin() + particles_.nFluid, particles_.p.end(), 0.0);
    std::fill(particles_.rho.begin() + particles_.nFluid, particles_.rho.end(), problem_.equationOfState.rho0);
    for (WallContact& contact : contact_)
    {
        contact = {0, Vec::Zero(), Vec::Zero(), contact.enclosed};
    }
    nearIsOld_ = true;
}

void WeaklyCompressible::addFriction(const RigidState& tank, std::vector<Vec>& acceleration)
{
    if (nearIsOld_)
    {
        friction_->findNear(particles_, schemes_.frame, tank, skin_.largest());
        nearIsOld_ = false;
    }
    friction_->addTo(particles_, schemes_.frame, tank, acceleration);
}

void WeaklyCompressible::updateWallState(const RigidState& tank)
{
    const auto section = profile_.section(Work::walls);
    moveWalls(tank);
    wallState_ = tank;
    if (schemes_.frame == Frame::inertial)
    {
        interactions_->packWallPositions(particles_, neighbours_);
    }
    interactions_->wallPressure(neighbours_, bodyForce(tank), schemes_.wallSuction, particles_, contact_);
    const auto& walls = neighbours_.wallsInReach();
    parallelFor(static_cast<std::ptrdiff_t>(walls.size()),
                [&](std::ptrdiff_t k)
                {
                    const int i = walls[k];
                    particles_.rho[i] = problem_.equationOfState.rho(particles_.p[i]);
                });
    interactions_->packWallFlow(particles_, neighbours_);
}

void WeaklyCompressible::updatePressure(double time)
{
    updatePressure(problem_.motion.at(time));
}

void WeaklyCompressible::updatePressure(const RigidState& tank)
{
    const auto section = profile_.section(Work::rightHandSides);
    parallelFor(particles_.nFluid,
                [&](std::ptrdiff_t i) { particles_.p[i] = problem_.equationOfState.p(particles_.rho[i]); });
    if (damper_)
    {
        damper_->addTo(particles_, schemes_.frame, tank);
    }
    interactions_->packLiquid(particles_);
    updateWallState(tank);
}

void WeaklyCompressible::evaluate(Wanted wanted, double time)
{
    const RigidState tank = problem_.motion.at(time);
    evaluate(wanted, tank);
    if (account_ && !integrator_->takesDensityRateHalfWay())
    {
        const auto section = profile_.section(Work::energyBudget);
        interactions_->rates(Wanted::walls, neighbours_, particles_, bodyForce(tank), walls_);
        account_->densityRateFound(particles_, rates_, walls_);
    }
}

void WeaklyCompressible::evaluateHalfWay(Wanted wanted, double begin, double end)
{
    const RigidState tank = problem_.motion.over(begin, end);
    evaluate(wanted, tank);
    if (!account_)
    {
        return;
    }
    const auto section = profile_.section(Work::energyBudget);
    if (!dissipation_.acceleration.empty())
    {
        interactions_->rates(Wanted::dissipation, neighbours_, particles_, bodyForce(tank), dissipation_);
        if (friction_)
        {
            addFriction(tank, dissipation_.acceleration);
        }
    }
    interactions_->rates(Wanted::walls, neighbours_, particles_, bodyForce(tank), walls_);
    account_->halfWay(*integrator_, particles_, rates_, dissipation_.acceleration, walls_, tank);
}

void WeaklyCompressible::evaluate(Wanted wanted, const RigidState& tank)
{
    sums_ += wanted == Wanted::both ? 2 : 1;
    updatePressure(tank);
    const auto section = profile_.section(Work::rightHandSides);
    interactions_->rates(wanted, neighbours_, particles_, bodyForce(tank), rates_);
    if (friction_ && wanted != Wanted::densityRate)
    {
        addFriction(tank, rates_.acceleration);
    }
}

void WeaklyCompressible::keepEnergyBudget(const TimeState& start)
{
    EnergyBudget budget;
    budget.since = start.time;
    budget.initial = liquidEnergies(particles_, problem_.equationOfState, problem_.gravity, schemes_.frame, start.tank,
                                    problem_.tank.thickness())
                         .total();
    account_.emplace(problem_, schemes_.frame, start.budget.value_or(budget));
    walls_.resize(particles_.nFluid);
    if (problem_.fluid.viscosity != FluidProperties::Viscosity::none || friction_)
    {
        dissipation_.resize(particles_.nFluid);
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
    const auto energy = [this]
    { return internalEnergy(particles_, problem_.equationOfState, problem_.tank.thickness()); };
    const double before = account_ ? energy() : 0;
    interactions_->movingLeastSquares(neighbours_, particles_, particles_.rho);
    if (account_)
    {
        account_->reinitialised(before, energy());
    }
    integrator_->forget();
}

double WeaklyCompressible::longestTimeStep(double maxCo) const
{
    return slosh::stableTimeStep(maxCo, problem_.kernel.smoothingLength(), problem_.equationOfState.c0, 0, 0,
                                 kinematicViscosity());
}

double WeaklyCompressible::kinematicViscosity() const
{
    const FluidProperties& fluid = problem_.fluid;
    return fluid.viscosity == FluidProperties::Viscosity::artificial
               ? fluid.alpha * problem_.kernel.smoothingLength() * problem_.equationOfState.c0 /
                     (2.0 * (problem_.tank.dim() + 2))
               : fluid.nu * integrator_->viscosityFactor();
}

double WeaklyCompressible::stableTimeStep(double maxCo) const
{
    const auto section = profile_.section(Work::timeStep);
    const double maxAcceleration2 = parallelReduce(
        particles_.nFluid, 0.0,
        [&](std::ptrdiff_t begin, std::ptrdiff_t end)
        {
            double most = 0;
            for (std::ptrdiff_t i = begin; i < end; ++i)
            {
                most = std::max(most, rates_.acceleration[i].squaredNorm());
            }
            return most;
        },
        [](double a, double b) { return std::max(a, b); });
    const double dt = slosh::stableTimeStep(maxCo, problem_.kernel.smoothingLength(), problem_.equationOfState.c0,
                                            extremes_.speed, std::sqrt(maxAcceleration2), kinematicViscosity());
    if (!(dt > 1e-3 * longestTimeStep(maxCo)))
    {
        std::ostringstream message;
        message << "the time step has collapsed to " << dt << " s: the largest acceleration is "
                << std::sqrt(maxAcceleration2) << " m/s^2, the largest speed " << extremes_.speed
                << " m/s.\nA smaller maxCo (system/controlDict), more viscosity or a smaller particleSpacing may help";
        throw UnphysicalRun(message.str());
    }
    return dt;
}

void WeaklyCompressible::findExtremes()
{
    const auto section = profile_.section(Work::timeStep);
    extremes_ = extremes(particles_, problem_.equationOfState.rho0);
}

void WeaklyCompressible::step(double time, double end)
{
    const auto section = profile_.section(Work::integration);
    integrator_->step(*this, time, end - time);
    const RigidState tank = problem_.motion.at(end);
    if (account_)
    {
        const auto budget = profile_.section(Work::energyBudget);
        account_->endOfStep(particles_, *integrator_, end - time);
    }
    bool someBehindWalls = true; // without walls nobody has looked
    if (particles_.nWall > 0)
    {
        const WallStops stops = stopAtWalls(problem_.tank, schemes_.frame, tank, problem_.equationOfState, particles_);
        stoppedAtWalls_ += stops.particles;
        someBehindWalls = stops.behind > 0;
        if (stops.particles > 0)
        {
            integrator_->forget(); // its rates are of the state before the stop
        }
        if (account_)
        {
            account_->stopped(stops, particles_.mass);
        }
    }
    findExtremes();
    const Soundness found = soundness(particles_, extremes_, problem_, schemes_, tank, someBehindWalls);
    outside_ = found.outside;
    if (!found.fault.empty())
    {
        integrator_->restore(particles_);
        if (account_)
        {
            account_->undo();
        }
        findExtremes();
        throw UnphysicalRun(found.fault);
    }
    if (damper_)
    {
        damper_->update(particles_, schemes_.frame, tank, rates_);
        damper_->findEnclosed(wallInTank_, contact_);
    }
    updateMeanDiffusion(time, end);
    if (friction_)
    {
        friction_->advance(particles_, contact_, schemes_.frame, wallState_, end - time);
    }
}

void WeaklyCompressible::updateMeanDiffusion(double time, double end)
{
    if (schemes_.densityDiffusion == 0)
    {
        return;
    }
    const double T = FourtakasDensityDiffusion::memory(problem_.kernel.smoothingLength(), problem_.equationOfState.c0);
    const double share = -std::expm1(-(end - time) / std::clamp(end - begin_, T / 10, T));
    parallelFor(particles_.nFluid,
                [&](std::ptrdiff_t i)
                {
                    double& mean = particles_.meanDiffusion[i];
                    // No liquid in reach: nothing to exchange volume with.
                    mean = rates_.diffusion[i] == 0 ? 0 : mean + share * (rates_.diffusion[i] - mean);
                });
}

TimeState WeaklyCompressible::state(double time, long index, double deltaT) const
{
    TimeState state = sampledState(time, index, deltaT);
    state.layers.assign(layers().begin(), layers().end());
    if (damper_)
    {
        state.sound = damper_->state();
    }
    return state;
}

TimeState WeaklyCompressible::sampledState(double time, long index, double deltaT) const
{
    TimeState state{time, index, deltaT, schemes_.frame, problem_.motion.at(time)};
    state.begin = begin_;
    if (account_)
    {
        state.budget = account_->budget();
    }
    return state;
}

std::span<const BoundaryLayer> WeaklyCompressible::layers() const
{
    return friction_ ? friction_->layers() : std::span<const BoundaryLayer>();
}

std::size_t WeaklyCompressible::bytes() const
{
    const std::size_t perParticle = 3 * sizeof(Vec) + 2 * sizeof(double) + sizeof(int);
    return particles_.r.capacity() * perParticle + neighbours_.bytes() + skin_.bytes() + interactions_->bytes() +
           integrator_->bytes() + rates_.acceleration.capacity() * (sizeof(Vec) + sizeof(double));
}

std::vector<std::string> WeaklyCompressible::description() const
{
    std::vector<std::string> lines = {"pair loop: " + interactions_->description()};
    const std::pair<bool, const char*> parts[] = {
        {problem_.tank.dim() == 2, "the empty direction"},
        {problem_.fluid.viscosity == FluidProperties::Viscosity::none, "viscosity"},
        {!friction_, "friction at walls"},
        {!damper_, "damping of sound"},
        {schemes_.densityDiffusion == 0, "density diffusion"},
        {problem_.motion.isStationary(), "the tank's motion and its fictitious forces"},
        {!problem_.motion.isStationary() && schemes_.frame == Frame::tank, "moving the walls (tank frame)"},
        {schemes_.densityInterval == 0, "density re-initialisation"},
        {problem_.tank.bodies().empty(), "bodies in the tank"},
        {schemes_.precision == Precision::single, "double precision of sums over pairs"},
        {!account_, "the energy budget"},
        {true, "wall particles with no liquid in reach"}};
    for (const auto& [isLeftOut, part] : parts)
    {
        if (isLeftOut)
        {
            lines.push_back(std::string("left out: ") + part);
        }
    }
    return lines;
}

} // namespace slosh
