// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/settle.hpp"

#include "particles/placesById.hpp"

#include <algorithm>
#include <cmath>

namespace slosh
{

Settled settle(const Scene& scene, const Schemes& schemes, const Vec& gravity, double time, Particles& particles)
{
    Scene atRest = scene.atRest(gravity);
    atRest.viscosity = ArtificialViscosity::of(scene.equationOfState, 1);
    Schemes ownSchemes = schemes;
    ownSchemes.frame = Frame::tank;
    ownSchemes.densityInterval = 0;
    ownSchemes.timeIntegration = "positionVerlet";

    const Particles before = particles;
    std::fill(particles.v.begin(), particles.v.begin() + particles.nFluid, Vec::Zero());
    const std::vector<Vec> walls(particles.r.begin() + particles.nFluid, particles.r.end());
    TimeState start;
    start.tank = atRest.motion->at(0);
    WeaklyCompressible solver(atRest, ownSchemes, particles, start, walls);

    constexpr double maxCo = 0.8;
    const double longest = solver.longestTimeStep(maxCo);
    Settled settled;
    for (double t = 0; t < time;)
    {
        solver.updateNeighbours(longest);
        solver.beginStep();
        const double end = t + solver.stableTimeStep(maxCo);
        solver.step(t, end);
        t = end;
        ++settled.steps;
        settled.speedOnWay = std::max(settled.speedOnWay, solver.maxSpeed());
    }
    solver.updatePressure();
    settled.speedLeft = solver.maxSpeed();
    particles = solver.particles();
    // The run does not begin with what the settling has left at the walls.
    std::erase_if(particles.more, [](const Field& field) { return field.range == ParticleRange::wall; });
    const auto places = placesById(before);
    for (std::ptrdiff_t i = 0; i < particles.nFluid; ++i)
    {
        const std::ptrdiff_t was = places.at(particles.id[i]);
        settled.moved = std::max(settled.moved, (particles.r[i] - before.r[was]).norm());
        particles.v[i] = before.v[was];
    }
    return settled;
}

} // namespace slosh
