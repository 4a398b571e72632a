#include "integration/PredictorCorrector.hpp"
#include "integration/stopAtWalls.hpp"
#include "integration/timeStep.hpp"

#include "dictionary/Dictionary.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace slosh
{
namespace
{

/// A particle on a damped spring, and a density that decays with time: both have exact solutions.
double errorAfterOneSecond(int steps)
{
    Particles particles;
    particles.resize(1, 0);
    particles.r[0] = Vec(1, 0, 0);
    particles.v[0] = Vec(-0.5, 0, 0);
    particles.rho[0] = 1000;
    PredictorCorrector integrator;
    Rates rates;
    rates.resize(1);
    const auto evaluate = [&]
    {
        rates.acceleration[0] = -9.25 * particles.r[0] - particles.v[0]; // x'' + x' + 9.25 x = 0: e^(-t/2) cos 3t
        rates.densityRate[0] = -2 * particles.rho[0];
    };
    const double dt = 1.0 / steps;
    for (int n = 0; n < steps; ++n)
    {
        evaluate();
        integrator.predict(particles, rates, dt);
        evaluate();
        integrator.correct(particles, rates, dt);
    }
    return std::abs(particles.r[0].x() - std::exp(-0.5) * std::cos(3.0)) +
           std::abs(particles.rho[0] / 1000 - std::exp(-2.0));
}

TEST(PredictorCorrector, IsOfSecondOrderInTime)
{
    for (int steps = 50; steps < 400; steps *= 2)
    {
        const double order = std::log2(errorAfterOneSecond(steps) / errorAfterOneSecond(2 * steps));
        EXPECT_NEAR(order, 2, 0.1) << steps << " steps";
    }
}

TEST(PredictorCorrector, IsExactUnderAConstantForce)
{
    Particles particles;
    particles.resize(1, 0);
    particles.v[0] = Vec(1, 2, 3);
    Rates rates;
    rates.resize(1);
    rates.acceleration[0] = Vec(0, 0, -9.81);
    PredictorCorrector integrator;
    integrator.predict(particles, rates, 0.5);
    EXPECT_NEAR((particles.r[0] - Vec(0.25, 0.5, 0.75)).norm(), 0, 1e-15);
    integrator.correct(particles, rates, 0.5);
    EXPECT_NEAR((particles.r[0] - Vec(0.5, 1, 1.5 - 9.81 / 8)).norm(), 0, 1e-14);
    EXPECT_NEAR((particles.v[0] - Vec(1, 2, 3 - 9.81 / 2)).norm(), 0, 1e-14);
}

TEST(PredictorCorrector, RestoresTheStateItWasGiven)
{
    Particles particles;
    particles.resize(2, 1);
    particles.r[1] = Vec(0.1, 0.2, 0.3);
    particles.v[1] = Vec(3, 2, 1);
    particles.rho = {1000, 1001, 1002};
    const Particles before = particles;
    Rates rates;
    rates.resize(2);
    rates.acceleration[1] = Vec(1e3, 0, 1e8);
    rates.densityRate[0] = 1e9;
    PredictorCorrector integrator;
    integrator.predict(particles, rates, 0.1);
    integrator.correct(particles, rates, 0.1);
    EXPECT_NE(particles.rho, before.rho);
    integrator.restore(particles);
    EXPECT_EQ(particles.rho, before.rho);
    EXPECT_EQ(particles.r[1], before.r[1]);
    EXPECT_EQ(particles.v[1], before.v[1]);
}

TEST(StopAtWalls, TakesOnlyWhatGoesIntoTheWallRelativeToIt)
{
    const Tank tank =
        Tank::read(Dictionary::parse("type box; min (0 0 0); max (1 1 1); fillDepth 0.5;", "constant/tankProperties"));
    RigidState state; // a tank that has turned and moves
    state.R = Eigen::AngleAxisd(0.3, Vec(1, 2, 3).normalized()).toRotationMatrix();
    state.c = Vec(0.1, -2, 0.4);
    state.velocity = Vec(5, 6, 7);
    state.omega = Vec(-1, 2, 0.5);
    const std::vector<Vec> X = {Vec(1.01, 0.5, 0.5), Vec(0.5, 0.5, 0.99), Vec(0.5, -0.01, 0.5), Vec(1.002, 0.5, 0.5)};
    const Vec V(2, 3, 4);                                                 // relative to the tank, along its axes
    const std::vector<Vec> expected = {Vec(0, 3, 4), V, V, Vec(0, 3, 4)}; // in a wall; beside one; leaving one; in one
    for (const Frame frame : {Frame::tank, Frame::inertial})
    {
        Particles particles;
        particles.resize(4, 0);
        const bool inTank = frame == Frame::tank;
        for (std::size_t i = 0; i < X.size(); ++i)
        {
            particles.r[i] = inTank ? X[i] : state.pointToInertial(X[i]);
            particles.v[i] = inTank ? V : Vec(state.velocityAt(X[i]) + state.R * V);
        }
        EXPECT_EQ(stopAtWalls(tank, frame, state, particles), 2);
        for (std::size_t i = 0; i < X.size(); ++i)
        {
            const Vec left =
                inTank ? particles.v[i] : Vec(state.R.transpose() * (particles.v[i] - state.velocityAt(X[i])));
            EXPECT_LT((left - expected[i]).norm(), 1e-12) << i;
        }
    }
}

TEST(StableTimeStep, IsTheSmallerOfTheAcousticAndTheAccelerationLimit)
{
    EXPECT_DOUBLE_EQ(stableTimeStep(0.25, 0.01, 18, 2, 0), 0.25 * 0.01 / 20);
    EXPECT_DOUBLE_EQ(stableTimeStep(0.25, 0.01, 18, 2, 10), 0.25 * 0.01 / 20);
    EXPECT_DOUBLE_EQ(stableTimeStep(0.25, 0.01, 18, 2, 1e6), 0.25 * 1e-4);
}

TEST(ViscousTimeStep, FallsWithTheSquareOfTheSmoothingLength)
{
    EXPECT_DOUBLE_EQ(viscousTimeStep(0.01, 0.05), 0.125 * 1e-4 / 0.05);
    EXPECT_DOUBLE_EQ(viscousTimeStep(0.005, 0.05), viscousTimeStep(0.01, 0.05) / 4);
}

} // namespace
} // namespace slosh
