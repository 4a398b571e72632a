// SPDX-License-Identifier: GPL-3.0-or-later
// Liquid that settles before a run: what it is then, and what it has not lost.
#include "solver/settle.hpp"

#include "dictionary/Dictionary.hpp"
#include "filling/fillTank.hpp"
#include "particles/liquidEnergies.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace slosh
{
namespace
{

constexpr double g = 9.81, D = 0.1, rho0 = 1000, dx = 0.01;

/// Water 0.1 m deep in a tank of 0.2 m that is about to sway; its particles have velocities of their own.
struct Column
{
    Scene scene{
        Tank::read(Dictionary::parse(
            "type box; plane xz; min (0 0 0); max (0.2 1 0.2); fillDepth 0.1;", "constant/tankProperties"
        )),
        Kernel::read(Dictionary::parse("kernel improvedGaussian;", "constant/kernelProperties"), 2, dx),
        SolidBodyMotion::stationary(),
        Vec(0, 0, -g),
        {rho0, 12, 7},
        {}};
    Particles start = fillTank(scene.tank, dx, 4, rho0, scene.equationOfState, g, 3.69).particles;

    Column()
    {
        for (std::ptrdiff_t i = 0; i < start.nFluid; ++i)
        {
            start.v[i] = Vec(start.id[i], 0, 1);
        }
    }
    Settled settleFor(double time, Particles& particles) const
    {
        return settle(scene, Schemes(), scene.gravity, time, particles);
    }
    /// The largest kinetic energy of a second's run that starts from `particles` at rest, over m g D.
    double restlessness(Particles particles) const
    {
        std::fill(particles.v.begin(), particles.v.end(), Vec::Zero());
        const std::vector<Vec> walls(particles.r.begin() + particles.nFluid, particles.r.end());
        TimeState now;
        now.tank = scene.motion->at(0);
        Schemes schemes;
        schemes.densityInterval = 0;
        Scene inviscid = scene;
        inviscid.viscosity = NoViscosity();
        WeaklyCompressible solver(inviscid, schemes, std::move(particles), now, walls);
        double most = 0;
        for (int n = 0; n < 2000; ++n)
        {
            constexpr double dt = 2e-4;
            solver.updateNeighbours(dt);
            solver.beginStep();
            solver.step(n * dt, (n + 1) * dt);
            most = std::max(
                most, liquidEnergies(solver.particles(), scene.equationOfState, scene.gravity, now.solverFrame(), 1)
                          .kineticInTank
            );
        }
        return most / (rho0 * 0.2 * D * g * D);
    }
};

TEST(Settle, LeavesAHydrostaticColumnThatIsAtRest)
{
    const Column column;
    Particles particles = column.start;
    const Settled settled = column.settleFor(2, particles);
    EXPECT_GT(settled.steps, 1000);
    EXPECT_GT(settled.speedOnWay, 20 * settled.speedLeft);
    EXPECT_LT(settled.moved, 0.2 * dx);
    // Kinetic energy: below 1e-7 of m g D.
    EXPECT_LT(settled.speedLeft * settled.speedLeft / 2, 1e-7 * g * D);
    for (std::ptrdiff_t i = 0; i < particles.nFluid; ++i)
    {
        const double p = column.scene.equationOfState.p(particles.rho[i]);
        const double depth = D - particles.r[i].z();
        // Near the surface particles lack neighbours.
        EXPECT_NEAR(p / (rho0 * g * D), depth / D, depth < 3 * dx ? 0.05 : 0.02) << particles.r[i].transpose();
        EXPECT_EQ(particles.p[i], p);
    }
}

TEST(LongSettle, LeavesLessThanATwentiethOfTheMotionThatTheLatticeStartsWith)
{
    const Column column;
    Particles particles = column.start;
    column.settleFor(2, particles);
    const double unsettled = column.restlessness(column.start);
    EXPECT_GT(unsettled, 1e-6);
    EXPECT_LT(column.restlessness(particles), 0.05 * unsettled);
}

TEST(Settle, KeepsTheVelocityOfEachParticleAndHasTheSameBitsTwice)
{
    const Column column;
    Particles once = column.start, again = column.start;
    column.settleFor(0.05, once);
    column.settleFor(0.05, again);
    bool sorted = true;
    for (std::ptrdiff_t i = 0; i < once.nFluid; ++i)
    {
        EXPECT_EQ(once.v[i], Vec(once.id[i], 0, 1));
        EXPECT_EQ(once.id[i], again.id[i]);
        EXPECT_EQ(once.r[i], again.r[i]);
        EXPECT_EQ(once.rho[i], again.rho[i]);
        sorted = sorted && once.id[i] == static_cast<int>(i);
    }
    EXPECT_FALSE(sorted) << "lists have not sorted the particles: their velocities could not have been mixed up";
}

} // namespace
} // namespace slosh
