// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/EnergyAccount.hpp"

#include "base/parallel.hpp"

#include <algorithm>
#include <functional>

namespace slosh
{

namespace
{

/// sum_i f(i) over the liquid, in a fixed order.
template <class F>
double sumOverLiquid(const Particles& particles, const F& f)
{
    return parallelReduce(
        particles.nFluid, 0.0,
        [&](std::ptrdiff_t begin, std::ptrdiff_t end)
        {
            double sum = 0;
            for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i)
            {
                sum += f(i);
            }
            return sum;
        },
        std::plus<>());
}

} // namespace

EnergyAccount::EnergyAccount(const SloshingProblem& problem, Frame frame, const EnergyBudget& budget)
    : problem_(problem), frame_(frame), budget_(budget), before_(budget)
{
}

void EnergyAccount::halfWay(const Particles& particles, const Rates& rates, const Rates& dissipation,
                            double powerOnWalls, const RigidState& tank)
{
    before_ = budget_;
    const bool inTank = frame_ == Frame::tank;
    const BodyForce bodyForce = bodyForceIn(frame_, problem_.gravity, tank);
    const Mat toSolver = inTank ? Mat(tank.R.transpose()) : Mat(Mat::Identity());
    // The velocity that the tank carries a place along with, along the solver's axes. That of a motion of the tank as a
    // whole does no work on pairs of liquid, whose forces are opposite and along their line.
    const auto carried = [&](std::size_t i) -> Vec
    { return toSolver * tank.velocityAt(pointInTank(particles.r[i], frame_, tank)); };
    const int empty = problem_.tank.emptyDirection();
    const double mass = particles.mass * problem_.tank.thickness();
    tankPower_ =
        mass * sumOverLiquid(particles,
                             [&](std::size_t i)
                             {
                                 Vec f = rates.acceleration[i] - bodyForce.onLiquid(particles.r[i], particles.v[i]);
                                 if (empty >= 0)
                                 {
                                     f[empty] = 0;
                                 }
                                 return f.dot(carried(i));
                             });
    wallPower_ = powerOnWalls * problem_.tank.thickness();
    carriedViscousPower_ = inTank || dissipation.acceleration.empty()
                               ? 0
                               : mass * sumOverLiquid(particles, [&](std::size_t i)
                                                      { return dissipation.acceleration[i].dot(carried(i)); });
}

void EnergyAccount::endOfStep(const Particles& particles, const TimeIntegrator& integrator, const Rates& dissipation,
                              double dt)
{
    budget_.work += dt * tankPower_;
    budget_.positiveWork += dt * std::max(0.0, tankPower_);
    budget_.walls += dt * wallPower_;
    if (dissipation.acceleration.empty())
    {
        return;
    }
    const double mass = particles.mass * problem_.tank.thickness();
    const double viscousPower =
        mass *
        sumOverLiquid(particles, [&](std::size_t i)
                      { return dissipation.acceleration[i].dot(integrator.velocityBefore()[i] + particles.v[i]) / 2; });
    const TaitEquation& state = problem_.equationOfState;
    const double diffusivePower =
        mass * sumOverLiquid(particles,
                             [&](std::size_t i)
                             {
                                 const double rho = (integrator.densityBefore()[i] + particles.rho[i]) / 2;
                                 return state.p(rho) / (rho * rho) * dissipation.densityRate[i];
                             });
    budget_.viscosity -= dt * (viscousPower - carriedViscousPower_);
    budget_.densityDiffusion -= dt * diffusivePower;
}

void EnergyAccount::damped(double power, double dt)
{
    budget_.viscosity += dt * power * problem_.tank.thickness();
}

void EnergyAccount::stopped(const WallStops& stops, double mass)
{
    const double m = mass * problem_.tank.thickness();
    budget_.work += m * stops.work;
    budget_.positiveWork += std::max(0.0, m * stops.work);
    budget_.stops += m * stops.taken;
}

} // namespace slosh
