// SPDX-License-Identifier: GPL-3.0-or-later
// What the liquid does to the tank, summed over walls, over the liquid's accelerations and from step to step.
#include "Sloshing.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace slosh
{
namespace
{

/// sum m v of the liquid, in the solver's frame.
Vec momentum(const WeaklyCompressible& solver, double thickness)
{
    const Particles& particles = solver.particles();
    Vec sum = Vec::Zero();
    for (std::ptrdiff_t i = 0; i < particles.nFluid; ++i)
    {
        sum += particles.mass * thickness * particles.v[i];
    }
    return sum;
}

TEST(MomentumBalance, OfAStepIsThatOfItsAccelerationsAndOfItsStops)
{
    for (const int dim : {2, 3})
    {
        const Sloshing scene(dim);
        Schemes schemes;
        schemes.precision = Precision::doublePrecision;
        schemes.timeIntegration = "predictorCorrector";
        WeaklyCompressible solver = scene.solver(
            schemes,
            [](Particles& particles)
            {
                for (const int i : {5, 7})
                {
                    particles.r[i].z() = 0.001; // 1.2 mm a step
                    particles.v[i] = Vec(0.5, 0, -6);
                }
            }
        );
        constexpr double dt = 2e-4;
        const double thickness = scene.scene.tank.thickness();
        const Vec before = momentum(solver, thickness);
        advance(solver, 1, dt);
        ASSERT_EQ(solver.stoppedAtWalls(), 2);
        const Vec after = momentum(solver, thickness);
        // The rates are still those half-way, which the step has taken.
        Vec taken = Vec::Zero();
        for (const Vec& a : solver.rates().acceleration)
        {
            taken += solver.particles().mass * thickness * dt * a;
        }
        const std::vector<Wrench> stops = solver.state(dt, 1, dt).stops;
        ASSERT_EQ(stops.size(), 1);
        const Vec left = after - before - taken + stops[0].force;
        EXPECT_LT(left.norm(), 1e-12 * stops[0].force.norm()) << dim << "D";
        // Towards the bottom, at the particles' places.
        EXPECT_LT(stops[0].force.z(), 0);
        EXPECT_NEAR(stops[0].force.x(), 0, 1e-15);
        Vec place = Vec::Zero();
        for (std::ptrdiff_t i = 0; i < solver.particles().nFluid; ++i)
        {
            if (solver.particles().r[i].z() < 0)
            {
                place += solver.particles().r[i] / 2;
            }
        }
        // Of two alike.
        EXPECT_LT((stops[0].moment - place.cross(stops[0].force)).norm(), 2e-3 * stops[0].moment.norm());
    }
}

/// A tank that only the liquid moves, along x.
class FreeTank final : public SolidBodyMotion
{
public:
    FreeTank(double mass, bool feelsLoad) : mass_(mass), feelsLoad_(feelsLoad) {}

    RigidState at(double) const override { return {}; }
    std::string description() const override { return "free"; }
    bool isMovedByLoad() const override { return feelsLoad_; }
    TankStep advance(const RigidState& now, double begin, double end, const Wrench& load) const override
    {
        const double dt = end - begin, a = load.force.x() / mass_;
        TankStep step{now, now};
        step.end.velocity.x() += a * dt;
        step.end.c.x() += dt * (now.velocity.x() + a * dt / 2);
        step.over.velocity.x() += a * dt / 2;
        step.over.c.x() += dt / 2 * (now.velocity.x() + a * dt / 4);
        step.over.acceleration.x() = step.end.acceleration.x() = a;
        return step;
    }

private:
    double mass_;
    bool feelsLoad_;
};

TEST(TankMotion, IsGivenTheLoadOfTheLiquidSoThatTheirMomentumStays)
{
    for (const std::string scheme : {"predictorCorrector", "positionVerlet"})
    {
        for (const bool feelsLoad : {true, false})
        {
            const double tankMass = 10; // of 2 kg of liquid
            Sloshing scene(2);
            scene.scene.motion = std::make_shared<FreeTank>(tankMass, feelsLoad);
            Schemes schemes;
            schemes.timeIntegration = scheme;
            WeaklyCompressible solver = scene.solver(
                schemes,
                [](Particles& particles)
                {
                    for (std::ptrdiff_t i = 0; i < particles.nFluid; ++i)
                    {
                        particles.v[i].x() = 0.2;
                    }
                }
            );
            const double thickness = scene.scene.tank.thickness();
            const Vec before = momentum(solver, thickness);
            constexpr double dt = 2e-4;
            constexpr long steps = 400;
            advance(solver, steps, dt);
            const TimeState now = solver.state(steps * dt, steps, dt);
            const double mass = solver.particles().mass * thickness * static_cast<double>(solver.particles().nFluid);
            const double V = now.tank.velocity.x();
            const double sum = momentum(solver, thickness).x() + (mass + tankMass) * V;
            if (feelsLoad)
            {
                EXPECT_GT(V, 0.02) << scheme;
                // Forces are taken a part of a step apart.
                EXPECT_NEAR(sum / before.x(), 1, 0.02) << scheme;
            }
            else
            {
                EXPECT_EQ(V, 0);
                EXPECT_LT(sum / before.x(), 0.5) << scheme;
            }
        }
    }
}

} // namespace
} // namespace slosh
