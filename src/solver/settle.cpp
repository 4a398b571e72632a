// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/settle.hpp"

#include <algorithm>
#include <cmath>

namespace slosh
{

Settled settle(const SloshingProblem& problem, const Schemes& schemes, const Vec& gravity, double time,
               Particles& particles)
{
    const auto still = SolidBodyMotion::stationary();
    SloshingProblem atRest{problem.tank, problem.kernel, *still, gravity, problem.equationOfState, problem.fluid};
    atRest.fluid.viscosity = FluidProperties::Viscosity::artificial;
    atRest.fluid.alpha = 1;
    Schemes ownSchemes = schemes;
    ownSchemes.frame = Frame::tank;
    ownSchemes.densityInterval = 0;
    ownSchemes.timeIntegration = "positionVerlet";

    // Lists sort the particles: by their ids they are found again.
    const std::ptrdiff_t nFluid = particles.nFluid;
    std::vector<Vec> v(nFluid), r(nFluid);
    for (std::size_t i = 0; i < nFluid; ++i)
    {
        const auto id = static_cast<std::size_t>(particles.id[i]);
        v[id] = particles.v[i];
        r[id] = particles.r[i];
        particles.v[i].setZero();
    }
    const std::vector<Vec> walls(particles.r.begin() + particles.nFluid, particles.r.end());
    TimeState start;
    start.tank = still->at(0);
    WeaklyCompressible solver(atRest, ownSchemes, particles, start, walls);

    constexpr double maxCo = 0.8;
    const double longest = solver.longestTimeStep(maxCo);
    Settled settled;
    for (double t = 0; t < time;)
    {
        solver.updateNeighbours(longest);
        solver.beginStep(t);
        const double end = t + solver.stableTimeStep(maxCo);
        solver.step(t, end);
        t = end;
        ++settled.steps;
        settled.speedOnWay = std::max(settled.speedOnWay, solver.maxSpeed());
    }
    solver.updatePressure(time);
    settled.speedLeft = solver.maxSpeed();
    particles = solver.particles();
    for (std::size_t i = 0; i < nFluid; ++i)
    {
        const auto id = static_cast<std::size_t>(particles.id[i]);
        settled.moved = std::max(settled.moved, (particles.r[i] - r[id]).norm());
        particles.v[i] = v[id];
    }
    return settled;
}

} // namespace slosh
