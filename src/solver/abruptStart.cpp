// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/abruptStart.hpp"

#include "particles/placesById.hpp"
#include "solver/WeaklyCompressible.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace slosh
{

namespace
{

/// Largest speed of the small jump over the speed of sound: no particle moves by more than a thousandth of a spacing.
constexpr double mach = 1e-6;
/// The mean is taken over this many periods of the slowest sound.
constexpr double periods = 4;

/// Of the slowest sound: a quarter wave of the depth under a surface, half a wave of the longest side without one, [s].
double slowestPeriod(const Scene& scene)
{
    const Tank& tank = scene.tank;
    const bool full = tank.fill().fromWallToWall() && tank.fill().level() >= tank.box().max().z();
    double length = 4 * tank.fillDepth();
    for (const int d : tank.directions())
    {
        length = full ? std::max(length, 2 * tank.box().sizes()[d]) : length;
    }
    return length / scene.equationOfState.c0;
}

/// Half the mean of |v|^2.
double energy(const std::vector<Vec>& v, int nFluid)
{
    double sum = 0;
    for (std::ptrdiff_t i = 0; i < nFluid; ++i)
    {
        sum += v[i].squaredNorm() / 2;
    }
    return sum / nFluid;
}

} // namespace

AbruptStart startAbruptly(const Scene& scene, Particles& particles)
{
    AbruptStart done;
    const std::ptrdiff_t nFluid = particles.nFluid;
    double jump = 0;
    for (std::ptrdiff_t i = 0; i < nFluid; ++i)
    {
        jump = std::max(jump, particles.v[i].norm());
    }
    if (jump == 0)
    {
        return done;
    }
    const double scale = mach * scene.equationOfState.c0 / jump;

    Scene small = scene.atRest(Vec::Zero());
    small.viscosity = ArtificialViscosity::of(scene.equationOfState, 0.02);
    small.fluid.slip = true;
    small.fluid.friction = {};
    small.wallSuction = true;
    Schemes schemes;
    schemes.frame = Frame::tank;
    schemes.timeIntegration = "positionVerlet";
    schemes.densityInterval = 0;
    schemes.soundDamping = 1;
    schemes.precision = Precision::doublePrecision;

    Particles moved = particles;
    const auto places = placesById(particles);
    for (std::ptrdiff_t i = 0; i < nFluid; ++i)
    {
        moved.v[i] *= scale;
        moved.rho[i] = scene.equationOfState.rho0;
        moved.p[i] = 0;
    }
    const std::vector<Vec> walls(moved.r.begin() + moved.nFluid, moved.r.end());
    TimeState start;
    start.tank = small.motion->at(0);
    WeaklyCompressible solver(small, schemes, std::move(moved), start, walls);

    constexpr double maxCo = 0.8;
    const double duration = periods * slowestPeriod(scene), longest = solver.longestTimeStep(maxCo);
    std::vector<Vec> sum(nFluid, Vec::Zero());
    double weights = 0;
    for (double t = 0; t < duration;)
    {
        solver.updateNeighbours(longest);
        solver.beginStep();
        const double end = std::min(duration, t + solver.stableTimeStep(maxCo));
        solver.step(t, end);
        // Hann's window: periods up to half of the duration leave next to nothing.
        const double weight = (end - t) * (1 - std::cos(2 * std::numbers::pi * end / duration));
        weights += weight;
        const Particles& now = solver.particles();
        for (std::ptrdiff_t i = 0; i < nFluid; ++i)
        {
            sum[places.at(now.id[i])] += weight * now.v[i];
        }
        t = end;
        ++done.steps;
    }
    done.energyBefore = energy(particles.v, particles.nFluid);
    for (std::ptrdiff_t i = 0; i < nFluid; ++i)
    {
        particles.v[i] = sum[i] / (weights * scale);
    }
    done.energyAfter = energy(particles.v, particles.nFluid);
    return done;
}

} // namespace slosh
