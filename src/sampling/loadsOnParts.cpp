// SPDX-License-Identifier: GPL-3.0-or-later
#include "sampling/loadsOnParts.hpp"

#include "base/parallel.hpp"
#include "physics/WallFriction.hpp"
#include "physics/wallState.hpp"

#include <algorithm>

namespace slosh
{

namespace
{

/// The part of the tank nearest to r, as NearestWall::part counts.
std::size_t partOf(const Tank& tank, const SolverFrame& frame, const Vec& r)
{
    return tank.bodies().empty() ? 0 : tank.nearestWall(frame.toTank(r)).part;
}

/// The velocity that wall particle w shows to the liquid.
Vec velocityShown(const Snapshot& snapshot, std::ptrdiff_t w)
{
    const Particles& particles = snapshot.particles();
    const Kernel& kernel = snapshot.scene().kernel;
    Vec towardsWall = Vec::Zero(), v = Vec::Zero();
    LiquidAtWall<3, double> seen;
    snapshot.forLiquidNear(
        particles.r[w],
        [&](std::ptrdiff_t f, const Vec& r)
        {
            const double W = kernel.W(r.norm());
            seen.W += W;
            seen.p += particles.p[f] * W;
            v += particles.v[f] * W;
            towardsWall += particles.rho[f] * W * r;
        }
    );
    const auto numbers = [](const Vec& x) { return std::array{x.x(), x.y(), x.z()}; };
    seen.v = numbers(v);
    seen.towardsWall = numbers(towardsWall);
    const auto shown = wallState(
        seen, numbers(particles.v[w]), numbers(snapshot.bodyForce().onRestingLiquid(particles.r[w])),
        snapshot.scene().wallSuction ? 1.0 : 0.0
    );
    return {shown.velocity[0], shown.velocity[1], shown.velocity[2]};
}

using Loads = std::vector<Load>; ///< by part

Loads operator+(Loads a, const Loads& b)
{
    for (std::size_t k = 0; k < a.size(); ++k)
    {
        a[k] = a[k] + b[k];
    }
    return a;
}

/// What each part's wall particles get from the liquid, over m^2, in the solver's axes.
template <int dim, class Viscosity>
Loads sumOverWalls(const Snapshot& snapshot, const Viscosity& viscosity, const Vec& origin)
{
    const Particles& particles = snapshot.particles();
    const Kernel& kernel = snapshot.scene().kernel;
    const auto& directions = snapshot.scene().tank.directions();
    const double h = kernel.smoothingLength();
    const auto Pi = viscosity.template inLoop<double>(dim, h);
    const auto inScene = [&](int d, const Vec& x) { return x[directions[d]]; };
    const auto record = [&](std::size_t i, const Vec& v)
    {
        Neighbour<dim, double> neighbour{};
        neighbour.P = particles.p[i] / (particles.rho[i] * particles.rho[i]);
        neighbour.s = 1 / particles.rho[i];
        for (int d = 0; d < dim; ++d)
        {
            neighbour.v[d] = inScene(d, v);
        }
        return neighbour;
    };
    const auto onWall = [&](Load& load, std::size_t w)
    {
        const Neighbour<dim, double> wall = record(w, velocityShown(snapshot, w));
        snapshot.forLiquidNear(
            particles.r[w],
            [&](std::ptrdiff_t i, const Vec& r_wf)
            {
                const Vec r = -r_wf;
                const Neighbour<dim, double> liquid = record(i, particles.v[i]);
                Pair<dim, double, true> pair{liquid, wall, {}, r.squaredNorm() / (h * h), 0};
                for (int d = 0; d < dim; ++d)
                {
                    pair.x[d] = inScene(d, r) / h;
                    pair.approach += (liquid.v[d] - wall.v[d]) * pair.x[d];
                }
                const Vec gradW = kernel.gradFactor(r.norm()) * r;
                const auto add = [&](Wrench& wrench, double perMass)
                {
                    const Vec force = perMass * gradW;
                    wrench += Wrench{force, (particles.r[i] - origin).cross(force)};
                };
                add(load.pressure, liquid.P + wall.P);
                if (!snapshot.scene().fluid.slip)
                {
                    add(load.viscous, 0.0 + Pi(pair, pair.approach));
                }
            }
        );
    };
    const Tank& tank = snapshot.scene().tank;
    const Loads none(tank.parts());
    return parallelReduce(
        particles.nWall, none,
        [&](std::ptrdiff_t begin, std::ptrdiff_t end)
        {
            Loads loads = none;
            for (std::ptrdiff_t k = begin; k < end; ++k)
            {
                const std::ptrdiff_t w = particles.nFluid + k;
                onWall(loads[partOf(tank, snapshot.frame(), particles.r[w])], w);
            }
            return loads;
        },
        [](const Loads& a, const Loads& b) { return a + b; }
    );
}

/// Adds what the walls' friction takes from the liquid, over m^2, in the solver's axes.
void addFriction(const Snapshot& snapshot, const Vec& origin, Loads& loads)
{
    const Scene& scene = snapshot.scene();
    const Particles& particles = snapshot.particles();
    const SolverFrame& frame = snapshot.frame();
    std::vector<Vec> walls(particles.nWall);
    std::transform(
        particles.r.begin() + particles.nFluid, particles.r.end(), walls.begin(),
        [&](const Vec& r) { return frame.toTank(r); }
    );
    WallFriction friction(
        scene.fluid, scene.tank, scene.fluid.sideWallDrag(scene.tank, scene.gravity), walls, particles
    );
    friction.findNear(particles, frame, 0);
    std::vector<Vec> acceleration(particles.nFluid, Vec::Zero());
    friction.addTo(particles, frame, acceleration);
    for (std::size_t i = 0; i < acceleration.size(); ++i)
    {
        if (!acceleration[i].isZero(0))
        {
            const Vec force = -acceleration[i] / particles.mass;
            loads[partOf(scene.tank, frame, particles.r[i])].viscous +=
                Wrench{force, (particles.r[i] - origin).cross(force)};
        }
    }
}

} // namespace

std::vector<Load> loadsOnParts(const Snapshot& snapshot, const Vec& CofR, bool tankAxes)
{
    const Scene& scene = snapshot.scene();
    const Particles& particles = snapshot.particles();
    const Vec origin = snapshot.frame().fromTank(CofR);
    snapshot.fluidGrid(); // built before threads ask for it
    Loads loads = std::visit(
        [&](const auto& viscosity)
        {
            return scene.tank.dim() == 2 ? sumOverWalls<2>(snapshot, viscosity, origin)
                                         : sumOverWalls<3>(snapshot, viscosity, origin);
        },
        scene.viscosity
    );
    if (scene.fluid.friction.boundaryLayers)
    {
        addFriction(snapshot, origin, loads);
    }
    const double m2 = particles.mass * particles.mass * scene.tank.thickness();
    const SolverFrame& frame = snapshot.frame();
    const auto inWanted = [&](const Vec& u) -> Vec
    { return m2 * (tankAxes ? frame.alongTank(u) : frame.alongInertial(u)); };
    for (Load& load : loads)
    {
        for (Wrench* wrench : {&load.pressure, &load.viscous})
        {
            wrench->force = inWanted(wrench->force);
            wrench->moment = inWanted(wrench->moment);
        }
    }
    return loads;
}

} // namespace slosh
