// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/EnergyAccount.hpp"

#include "base/parallel.hpp"
#include "particles/liquidEnergies.hpp"
#include "particles/reduce.hpp"
#include "physics/FourtakasDensityDiffusion.hpp"
#include "physics/bodyForceIn.hpp"
#include "physics/loadByMomentum.hpp"
#include "viscosities/readViscosity.hpp"

#include <algorithm>

namespace slosh
{

EnergyAccount::EnergyAccount(
    const Scene& scene, const Particles& particles, const SolverFrame& frame, const TimeState& start, bool friction
)
    : scene_(scene)
{
    if (start.budget)
    {
        budget_ = *start.budget;
    }
    else
    {
        budget_.since = start.time;
        budget_.initial =
            liquidEnergies(particles, scene.equationOfState, scene.gravity, frame, scene.tank.thickness()).total();
    }
    before_ = budget_;
    const bool viscous = !isNone(scene.viscosity) || friction;
    viscousPart_.resize(viscous ? particles.nFluid : 0, Vec::Zero());
    wallPart_.resize(particles.nFluid);
}

void EnergyAccount::keepDensityRate(const Particles& particles, const Rates& rates)
{
    std::swap(atStart_, atEnd_);
    atEnd_.all = rates.densityRate;
    atEnd_.walls = wallPart_.densityRate;
    atEnd_.diffusion = rates.diffusion;
    const auto mean = particles.values<double>(FourtakasDensityDiffusion::meanField);
    for (std::size_t i = 0; i < mean.size(); ++i)
    {
        atEnd_.diffusion[i] -= mean[i];
    }
}

void EnergyAccount::evaluated(
    Stage stage, const Interactions& pairs, const ClusterLists& lists, const TimeIntegrator& integrator,
    const Particles& particles, const Rates& rates, const SolverFrame& frame, Walls& walls
)
{
    if (stage != Stage::halfWay)
    {
        if (!integrator.takesDensityRateHalfWay())
        {
            pairs.budgetParts(true, lists, particles, viscousPart_, wallPart_);
            keepDensityRate(particles, rates);
        }
        return;
    }
    before_ = budget_;
    pairs.budgetParts(false, lists, particles, viscousPart_, wallPart_);
    walls.addFriction(particles, frame, viscousPart_);
    if (integrator.takesDensityRateHalfWay())
    {
        keepDensityRate(particles, rates);
    }
    halfWay(particles, rates, frame);
}

void EnergyAccount::halfWay(const Particles& particles, const Rates& rates, const SolverFrame& frame)
{
    const BodyForce bodyForce = bodyForceIn(frame, scene_.gravity);
    // That of a motion of the tank as a whole does no work on pairs of liquid, whose forces are opposite and along
    // their line.
    const auto carried = [&](std::ptrdiff_t i) { return frame.carried(particles.r[i]); };
    const int empty = scene_.tank.emptyDirection();
    const double mass = particles.mass * scene_.tank.thickness();
    tankPower_ =
        mass * sumOverLiquid(
                   particles, [&](std::ptrdiff_t i)
                   { return accelerationByContact(particles, rates.acceleration, bodyForce, empty, i).dot(carried(i)); }
               );
    const auto keep = [&](Force& force, const std::vector<Vec>& f)
    {
        force.f = f;
        force.carried = frame.wallsRest() || f.empty()
                            ? 0
                            : mass * sumOverLiquid(particles, [&](std::ptrdiff_t i) { return f[i].dot(carried(i)); });
    };
    keep(viscous_, viscousPart_);
    keep(walls_, wallPart_.acceleration);
    pressure_.resize(particles.nFluid);
    dampingPressure_.resize(pressure_.size());
    parallelFor(
        particles.nFluid,
        [&](std::ptrdiff_t i)
        {
            const double rho = particles.rho[i];
            pressure_[i] = particles.p[i] / (rho * rho);
            dampingPressure_[i] = (particles.p[i] - scene_.equationOfState.p(rho)) / (rho * rho);
        }
    );
}

void EnergyAccount::endOfStep(const Particles& particles, const TimeIntegrator& integrator, double dt)
{
    const double mass = particles.mass * scene_.tank.thickness();
    const auto power = [&](const Force& force)
    {
        return force.f.empty()
                   ? 0
                   : mass * sumOverLiquid(
                                particles, [&](std::ptrdiff_t i)
                                { return force.f[i].dot(integrator.velocityBefore()[i] + particles.v[i]) / 2; }
                            ) -
                         force.carried;
    };
    const auto compression =
        [&](const std::vector<double>& p, const std::vector<double>& D0, const std::vector<double>& D1)
    { return mass * sumOverLiquid(particles, [&](std::ptrdiff_t i) { return p[i] * (D0[i] + D1[i]) / 2; }); };
    const DensityRate& atStart = integrator.takesDensityRateHalfWay() ? atEnd_ : atStart_;
    budget_.work += dt * tankPower_;
    budget_.positiveWork += dt * std::max(0.0, tankPower_);
    budget_.viscosity += dt * (compression(dampingPressure_, atStart.all, atEnd_.all) - power(viscous_));
    budget_.densityDiffusion -= dt * compression(pressure_, atStart.diffusion, atEnd_.diffusion);
    budget_.walls -= dt * (power(walls_) + compression(pressure_, atStart.walls, atEnd_.walls));
}

void EnergyAccount::stopped(const WallStops& stops, double mass)
{
    const double m = mass * scene_.tank.thickness();
    budget_.work += m * stops.work;
    budget_.positiveWork += std::max(0.0, m * stops.work);
    budget_.stops += m * stops.taken;
}

} // namespace slosh
