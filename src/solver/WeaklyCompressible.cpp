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
#include "particles/reduce.hpp"
#include "physics/FourtakasDensityDiffusion.hpp"
#include "physics/chooseViscosity.hpp"
#include "physics/makeInteractions.hpp"
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

WeaklyCompressible::WeaklyCompressible(const Scene& scene, const Schemes& schemes, Particles particles,
                                       const TimeState& start, std::vector<Vec> wallInTank)
    : scene_(scene), schemes_(schemes), particles_(std::move(particles)), wallInTank_(std::move(wallInTank)),
      interactions_(
          makeInteractions(pairGeometry(scene.tank, scene.kernel), scene.kernel.choice(),
                           {chooseViscosity(scene.fluid, scene.equationOfState, scene.kernel.smoothingLength()),
                            chooseDensityDiffusion(schemes.densityDiffusion, scene.equationOfState), scene.fluid.slip},
                           schemes.precision)),
      integrator_(TimeIntegrator::make(schemes.timeIntegration)), wallFrame_(schemes.frame, start.tank)
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
    std::vector<Field> remembered;
    if (schemes_.densityDiffusion > 0)
    {
        remembered.push_back(FourtakasDensityDiffusion::mean());
    }
    if (scene_.fluid.friction.boundaryLayers)
    {
        const std::vector<Field> layers = WallFriction::layerFields();
        remembered.insert(remembered.end(), layers.begin(), layers.end());
    }
    particles_.remember(std::move(remembered));
    changeFrame(particles_, start.solverFrame(), schemes_.frame);
    if (wallFrame_.wallsRest())
    {
        std::copy(wallInTank_.begin(), wallInTank_.end(), particles_.r.begin() + particles_.nFluid);
        std::fill(particles_.v.begin() + particles_.nFluid, particles_.v.end(), Vec::Zero());
    }
    moveWalls(wallFrame_);
    if (scene_.fluid.friction.boundaryLayers)
    {
        friction_.emplace(scene_.fluid, scene_.tank, scene_.fluid.sideWallDrag(scene_.tank, scene_.gravity),
                          wallInTank_, particles_);
    }
    contact_.resize(friction_ || schemes_.soundDamping > 0 ? wallInTank_.size() : 0);
    if (schemes_.soundDamping > 0)
    {
        const double L = schemes_.dampingLength > 0 ? schemes_.dampingLength
                                                    : AcousticDamper::length(scene_.tank, particles_.spacing);
        damper_.emplace(scene_.tank, L, schemes_.soundDamping * L * scene_.equationOfState.c0,
                        scene_.equationOfState.rho0, start.sound);
        damper_->findEnclosed(wallInTank_, contact_);
    }
    rates_.resize(particles_.nFluid);
    begin_ = start.begin;
    findExtremes();
}

void WeaklyCompressible::moveWalls(const SolverFrame& frame)
{
    if (frame.wallsRest())
    {
        return;
    }
    parallelFor(particles_.nWall,
                [&](std::ptrdiff_t k)
                {
                    const Vec& X = wallInTank_[k];
                    particles_.r[particles_.nFluid + k] = frame.fromTank(X);
                    particles_.v[particles_.nFluid + k] = frame.wallVelocity(X);
                });
}

void WeaklyCompressible::updateNeighbours(double longestStep)
{
    const auto section = profile_.section(Work::lists);
    if (!skin_.mustRebuild(particles_, longestStep, extremes_.speed))
    {
        return;
    }
    const double support = scene_.kernel.supportRadius();
    sortByCell(particles_, support); // not by the reach: where particles stand shall be a function of them alone
    skin_.choose(particles_, !wallFrame_.wallsRest(), support, longestStep);
    neighbours_.build(particles_, support, skin_.skins(), interactions_->lanes());
    interactions_->listBuilt(particles_, neighbours_, support + skin_.largest());
    skin_.listBuilt(particles_);
    integrator_->forget(); // the particles stand in another order
    ++rebuilds_;
    // Walls that have no liquid in reach keep this state until the next list.
    std::fill(particles_.p.begin() + particles_.nFluid, particles_.p.end(), 0.0);
    std::fill(particles_.rho.begin() + particles_.nFluid, particles_.rho.end(), scene_.equationOfState.rho0);
    for (WallContact& contact : contact_)
    {
        contact = {0, Vec::Zero(), Vec::Zero(), contact.enclosed};
    }
    nearIsOld_ = true;
}

void WeaklyCompressible::addFriction(const SolverFrame& frame, std::vector<Vec>& acceleration)
{
    if (nearIsOld_)
    {
        friction_->findNear(particles_, frame, skin_.largest());
        nearIsOld_ = false;
    }
    friction_->addTo(particles_, frame, acceleration);
}

void WeaklyCompressible::updatePressure(double time)
{
    updatePressure(frameAt(time));
}

void WeaklyCompressible::updatePressure(const SolverFrame& frame)
{
    const auto section = profile_.section(Work::rightHandSides);
    parallelFor(particles_.nFluid,
                [&](std::ptrdiff_t i) { particles_.p[i] = scene_.equationOfState.p(particles_.rho[i]); });
    if (damper_)
    {
        damper_->addTo(particles_, frame);
    }
    const auto walls = profile_.section(Work::walls);
    wallFrame_ = frame;
    if (!frame.wallsRest())
    {
        moveWalls(frame);
        interactions_->packWallPositions(particles_, neighbours_);
    }
    interactions_->see(neighbours_, bodyForce(frame), scene_.equationOfState, scene_.wallSuction, particles_, contact_);
}

void WeaklyCompressible::evaluate(Wanted wanted, double time)
{
    const SolverFrame frame = frameAt(time);
    evaluate(wanted, frame);
    if (account_ && !integrator_->takesDensityRateHalfWay())
    {
        const auto section = profile_.section(Work::energyBudget);
        interactions_->budgetParts(true, neighbours_, particles_, viscous_, walls_);
        account_->densityRateFound(particles_, rates_, walls_);
    }
}

void WeaklyCompressible::evaluateHalfWay(Wanted wanted, double begin, double end)
{
    const SolverFrame frame(schemes_.frame, scene_.motion->over(begin, end));
    evaluate(wanted, frame);
    if (!account_)
    {
        return;
    }
    const auto section = profile_.section(Work::energyBudget);
    interactions_->budgetParts(false, neighbours_, particles_, viscous_, walls_);
    if (friction_)
    {
        addFriction(frame, viscous_);
    }
    account_->halfWay(*integrator_, particles_, rates_, viscous_, walls_, frame);
}

void WeaklyCompressible::evaluate(Wanted wanted, const SolverFrame& frame)
{
    sums_ += wanted == Wanted::both ? 2 : 1;
    updatePressure(frame);
    const auto section = profile_.section(Work::rightHandSides);
    interactions_->rates(wanted, neighbours_, particles_, bodyForce(frame), rates_);
    if (friction_ && wanted != Wanted::densityRate)
    {
        addFriction(frame, rates_.acceleration);
    }
}

void WeaklyCompressible::keepEnergyBudget(const TimeState& start)
{
    EnergyBudget budget;
    budget.since = start.time;
    budget.initial = liquidEnergies(particles_, scene_.equationOfState, scene_.gravity,
                                    SolverFrame(schemes_.frame, start.tank), scene_.tank.thickness())
                         .total();
    account_.emplace(scene_, start.budget.value_or(budget));
    walls_.resize(particles_.nFluid);
    if (scene_.fluid.viscosity != FluidProperties::Viscosity::none || friction_)
    {
        viscous_.resize(particles_.nFluid);
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
    interactions_->movingLeastSquares(neighbours_, particles_, particles_.rho);
    if (account_)
    {
        account_->reinitialised(before, energy());
    }
    integrator_->forget();
}

double WeaklyCompressible::longestTimeStep(double maxCo) const
{
    return slosh::stableTimeStep(maxCo, scene_.kernel.smoothingLength(), scene_.equationOfState.c0, 0, 0,
                                 kinematicViscosity());
}

double WeaklyCompressible::kinematicViscosity() const
{
    const FluidProperties& fluid = scene_.fluid;
    return fluid.viscosity == FluidProperties::Viscosity::artificial
               ? fluid.alpha * scene_.kernel.smoothingLength() * scene_.equationOfState.c0 /
                     (2.0 * (scene_.tank.dim() + 2))
               : fluid.nu * integrator_->viscosityFactor();
}

double WeaklyCompressible::stableTimeStep(double maxCo) const
{
    const auto section = profile_.section(Work::timeStep);
    const double maxAcceleration =
        std::sqrt(maxOverLiquid(particles_, [&](std::ptrdiff_t i) { return rates_.acceleration[i].squaredNorm(); }));
    const double dt = slosh::stableTimeStep(maxCo, scene_.kernel.smoothingLength(), scene_.equationOfState.c0,
                                            extremes_.speed, maxAcceleration, kinematicViscosity());
    if (!(dt > 1e-3 * longestTimeStep(maxCo)))
    {
        std::ostringstream message;
        message << "the time step has collapsed to " << dt << " s: the largest acceleration is " << maxAcceleration
                << " m/s^2, the largest speed " << extremes_.speed
                << " m/s.\nA smaller maxCo (system/controlDict), more viscosity or a smaller particleSpacing may help";
        throw UnphysicalRun(message.str());
    }
    return dt;
}

void WeaklyCompressible::findExtremes()
{
    const auto section = profile_.section(Work::timeStep);
    extremes_ = extremes(particles_, scene_.equationOfState.rho0);
}

void WeaklyCompressible::step(double time, double end)
{
    const auto section = profile_.section(Work::integration);
    integrator_->step(*this, time, end - time);
    const SolverFrame frame = frameAt(end);
    if (account_)
    {
        const auto budget = profile_.section(Work::energyBudget);
        account_->endOfStep(particles_, *integrator_, end - time);
    }
    bool someBehindWalls = true; // without walls nobody has looked
    if (particles_.nWall > 0)
    {
        const WallStops stops = stopAtWalls(scene_.tank, frame, scene_.equationOfState, particles_);
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
    const Soundness found = soundness(particles_, extremes_, scene_, schemes_, frame, someBehindWalls);
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
        damper_->update(particles_, frame, rates_);
        damper_->findEnclosed(wallInTank_, contact_);
    }
    updateMeanDiffusion(time, end);
    if (friction_)
    {
        friction_->advance(particles_, contact_, wallFrame_, end - time);
    }
}

void WeaklyCompressible::updateMeanDiffusion(double time, double end)
{
    if (schemes_.densityDiffusion == 0)
    {
        return;
    }
    const double T = FourtakasDensityDiffusion::memory(scene_.kernel.smoothingLength(), scene_.equationOfState.c0);
    const double share = -std::expm1(-(end - time) / std::clamp(end - begin_, T / 10, T));
    const auto means = particles_.values<double>(FourtakasDensityDiffusion::meanField);
    parallelFor(particles_.nFluid,
                [&](std::ptrdiff_t i)
                {
                    double& mean = means[i];
                    // No liquid in reach: nothing to exchange volume with.
                    mean = rates_.diffusion[i] == 0 ? 0 : mean + share * (rates_.diffusion[i] - mean);
                });
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

std::size_t WeaklyCompressible::bytes() const
{
    return particles_.bytes() + neighbours_.bytes() + skin_.bytes() + interactions_->bytes() + integrator_->bytes() +
           rates_.acceleration.capacity() * (sizeof(Vec) + sizeof(double));
}

std::vector<std::string> WeaklyCompressible::description() const
{
    std::vector<std::string> lines = {"pair loop: " + interactions_->description()};
    const std::pair<bool, const char*> parts[] = {
        {scene_.tank.dim() == 2, "the empty direction"},
        {scene_.fluid.viscosity == FluidProperties::Viscosity::none, "viscosity"},
        {!friction_, "friction at walls"},
        {!damper_, "damping of sound"},
        {schemes_.densityDiffusion == 0, "density diffusion"},
        {scene_.motion->isStationary(), "the tank's motion and its fictitious forces"},
        {!scene_.motion->isStationary() && wallFrame_.wallsRest(), "moving the walls (tank frame)"},
        {schemes_.densityInterval == 0, "density re-initialisation"},
        {scene_.tank.bodies().empty(), "bodies in the tank"},
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
