// SPDX-License-Identifier: GPL-3.0-or-later
#include "integration/PositionVerlet.hpp"
#include "integration/PredictorCorrector.hpp"
#include "integration/stopAtWalls.hpp"
#include "integration/timeStep.hpp"

#include "dictionary/Dictionary.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace slosh
{
namespace
{

/// Equations given as a function of the state and the time.
class Equations final : public RightHandSides
{
public:
    Equations(Particles& particles, std::function<void(const Particles&, double, Rates&)> f)
        : particles_(particles), f_(std::move(f))
    {
        rates_.resize(particles.nFluid);
    }

    Particles& state() override { return particles_; }
    const Rates& rates() const override { return rates_; }
    void evaluate(Wanted wanted, Stage stage) override
    {
        ++evaluations;
        Rates all = rates_;
        f_(particles_, time_ + (stage == Stage::begin ? 0 : stage == Stage::halfWay ? dt_ / 2 : dt_), all);
        if (wanted != Wanted::densityRate)
        {
            rates_.acceleration = all.acceleration;
        }
        if (wanted != Wanted::acceleration)
        {
            rates_.densityRate = all.densityRate;
        }
    }

    /// The next step.
    void advance(TimeIntegrator& integrator, double dt)
    {
        dt_ = dt;
        integrator.begin(*this);
        integrator.step(*this, dt);
        time_ += dt;
    }

    int evaluations = 0;

private:
    Particles& particles_;
    std::function<void(const Particles&, double, Rates&)> f_;
    Rates rates_;
    double time_ = 0, dt_ = 0;
};

class Integrators : public testing::TestWithParam<std::string>
{
protected:
    std::unique_ptr<TimeIntegrator> integrator() const { return TimeIntegrator::make(GetParam()); }
};

INSTANTIATE_TEST_SUITE_P(
    All, Integrators, testing::ValuesIn(TimeIntegrator::names()), [](const auto& info) { return info.param; }
);

/// A particle on a damped spring that is also driven, and a density that decays with time: both have exact solutions.
double errorAfterOneSecond(TimeIntegrator& integrator, int steps)
{
    Particles particles;
    particles.resize(1, 0);
    particles.r[0] = Vec(1, 0, 0);
    particles.v[0] = Vec(-0.5, 0, 0);
    particles.rho[0] = 1000;
    Equations equations(
        particles,
        [](const Particles& p, double t, Rates& rates)
        {
            // x'' + x' + 9.25 x = 0: e^(-t/2) cos 3t; y'' = cos t: 1 - cos t
            rates.acceleration[0] = -9.25 * p.r[0] - p.v[0];
            rates.acceleration[0].y() = std::cos(t);
            rates.densityRate[0] = -2 * p.rho[0];
        }
    );
    const double dt = 1.0 / steps;
    for (int n = 0; n < steps; ++n)
    {
        equations.advance(integrator, dt);
    }
    return std::abs(particles.r[0].x() - std::exp(-0.5) * std::cos(3.0)) +
           std::abs(particles.r[0].y() - (1 - std::cos(1.0))) + std::abs(particles.rho[0] / 1000 - std::exp(-2.0));
}

TEST_P(Integrators, AreOfSecondOrderInTime)
{
    for (int steps = 50; steps < 400; steps *= 2)
    {
        const double order =
            std::log2(errorAfterOneSecond(*integrator(), steps) / errorAfterOneSecond(*integrator(), 2 * steps));
        EXPECT_NEAR(order, 2, 0.15) << steps << " steps";
    }
}

TEST_P(Integrators, AreExactUnderAConstantForce)
{
    Particles particles;
    particles.resize(1, 0);
    particles.v[0] = Vec(1, 2, 3);
    Equations equations(
        particles, [](const Particles&, double, Rates& rates) { rates.acceleration[0] = Vec(0, 0, -9.81); }
    );
    const auto scheme = integrator();
    equations.advance(*scheme, 0.5);
    EXPECT_NEAR((particles.r[0] - Vec(0.5, 1, 1.5 - 9.81 / 8)).norm(), 0, 1e-14);
    EXPECT_NEAR((particles.v[0] - Vec(1, 2, 3 - 9.81 / 2)).norm(), 0, 1e-14);
}

TEST_P(Integrators, StateLimitsAboveTheDefaultStep)
{
    EXPECT_GT(integrator()->largestStableCo(), 0.25);
    EXPECT_GT(integrator()->unstableCo(), integrator()->largestStableCo());
}

TEST_P(Integrators, RestoreTheStateTheyWereGiven)
{
    Particles particles;
    particles.resize(2, 1);
    particles.r[1] = Vec(0.1, 0.2, 0.3);
    particles.v[1] = Vec(3, 2, 1);
    particles.rho = {1000, 1001, 1002};
    const Particles before = particles;
    Equations equations(
        particles,
        [](const Particles&, double, Rates& rates)
        {
            rates.acceleration[1] = Vec(1e3, 0, 1e8);
            rates.densityRate[0] = 1e9;
        }
    );
    const auto scheme = integrator();
    equations.advance(*scheme, 0.1);
    EXPECT_NE(particles.rho, before.rho);
    scheme->restore(particles);
    EXPECT_EQ(particles.rho, before.rho);
    EXPECT_EQ(particles.r[1], before.r[1]);
    EXPECT_EQ(particles.v[1], before.v[1]);
}

/// (rho - 1000, v) of a sound oscillation v' = omega (rho - 1000), rho' = -omega v after 2000 steps of dt = z/omega;
/// (1, 0) before.
Vec2 soundAfter2000Steps(TimeIntegrator& integrator, double z)
{
    Particles particles;
    particles.resize(1, 0);
    particles.rho[0] = 1001;
    Equations equations(
        particles,
        [](const Particles& p, double, Rates& rates)
        {
            rates.acceleration[0] = Vec(p.rho[0] - 1000, 0, 0);
            rates.densityRate[0] = -p.v[0].x();
        }
    );
    for (int n = 0; n < 2000; ++n)
    {
        equations.advance(integrator, z);
    }
    return {particles.rho[0] - 1000, particles.v[0].x()};
}

TEST(PositionVerlet, KeepsTheInvariantOfSoundUpToTwoOverTheStep)
{
    // A step is (x, v) -> (a x - b v, z x + a v), a = 1 - z^2/2, b = z (1 - z^2/4): it keeps x^2 + (b/z) v^2.
    PositionVerlet scheme;
    for (const double z : {0.1, 0.5, 1.0, 1.5, 1.9})
    {
        const Vec2 sound = soundAfter2000Steps(scheme, z);
        EXPECT_NEAR(sound[0] * sound[0] + (1 - z * z / 4) * sound[1] * sound[1], 1, 1e-8) << z;
        scheme.forget();
    }
    EXPECT_GT(soundAfter2000Steps(scheme, 2.01).norm(), 1e6);
}

TEST(PredictorCorrector, LetsSoundGrowByTheFourthPowerOfTheStep)
{
    PredictorCorrector scheme;
    for (const double z : {0.1, 0.2})
    {
        EXPECT_NEAR(std::log(soundAfter2000Steps(scheme, z).norm()) / (2000 * std::pow(z, 4) / 8), 1, 0.05) << z;
    }
}

TEST(PositionVerlet, EvaluatesEachRateOnceAStepUnlessItMustForget)
{
    Particles particles;
    particles.resize(1, 0);
    Equations equations(particles, [](const Particles&, double, Rates&) {});
    PositionVerlet scheme;
    for (int n = 0; n < 10; ++n)
    {
        equations.advance(scheme, 0.1);
    }
    EXPECT_EQ(equations.evaluations, 1 + 2 * 10);
    scheme.forget();
    scheme.begin(equations);
    EXPECT_EQ(equations.evaluations, 1 + 2 * 10 + 1);
}

TEST(StopAtWalls, TakesOnlyWhatGoesIntoTheWallRelativeToItAndCompressesAsAWaterHammerWould)
{
    const Tank tank =
        Tank::read(Dictionary::parse("type box; min (0 0 0); max (1 1 1); fillDepth 0.5;", "constant/tankProperties"));
    RigidState state; // a tank that has turned and moves
    state.R = Eigen::AngleAxisd(0.3, Vec(1, 2, 3).normalized()).toRotationMatrix();
    state.c = Vec(0.1, -2, 0.4);
    state.velocity = Vec(5, 6, 7);
    state.omega = Vec(-1, 2, 0.5);
    const std::vector<Vec> X = {
        Vec(1.01, 0.5, 0.5), Vec(0.5, 0.5, 0.99), Vec(0.5, -0.01, 0.5), Vec(1.002, 0.5, 0.5), Vec(1.003, 0.5, 0.5)};
    const Vec V(2, 3, 4); // relative to the tank, along its axes
    // In a wall; beside one; leaving one; in one, twice.
    const std::vector<Vec> expected = {Vec(0, 3, 4), V, V, Vec(0, 3, 4), Vec(0, 3, 4)};
    const TaitEquation equationOfState{1000, 1000, 7};
    const double hammer = 1000.0 * 1000 * 2;                         // of 2 m/s, [Pa]
    const std::vector<double> p = {-1e4, -1e4, -1e4, 0, 2 * hammer}; // tension; none; pressed
    const std::vector<double> compressed = {hammer, -1e4, -1e4, hammer, 2 * hammer};
    for (const Frame frame : {Frame::tank, Frame::inertial})
    {
        Particles particles;
        particles.resize(5, 0);
        const bool inTank = frame == Frame::tank;
        for (std::size_t i = 0; i < X.size(); ++i)
        {
            particles.r[i] = inTank ? X[i] : state.pointToInertial(X[i]);
            particles.v[i] = inTank ? V : Vec(state.velocityAt(X[i]) + state.R * V);
            particles.rho[i] = equationOfState.rho(p[i]);
        }
        const auto energy = [&]
        {
            double sum = 0; // kinetic, in the inertial frame, and of compression
            for (std::size_t i = 0; i < X.size(); ++i)
            {
                const Vec& v = particles.v[i];
                sum += (inTank ? Vec(state.velocityAt(X[i]) + state.R * v) : v).squaredNorm() / 2 +
                       equationOfState.energy(particles.rho[i]);
            }
            return sum;
        };
        const double before = energy();
        const WallStops stops = stopAtWalls(tank, {frame, state}, equationOfState, particles);
        EXPECT_EQ(stops.particles, 3);
        EXPECT_NEAR(energy() - before, stops.work - stops.taken, 1e-11);
        const double tension = equationOfState.energy(equationOfState.rho(-1e4));
        const double twice = 2 * 8 / 3.0 * 2 * 2 * 2 / 1000; // (gamma + 1)/3 u^3/c0, by the series of Tait's equation
        const double pressed = 2 * 2 / 2.0;                  // it keeps its pressure
        EXPECT_NEAR(stops.taken - tension - pressed, twice, 0.02 * twice);
        for (std::size_t i = 0; i < X.size(); ++i)
        {
            const Vec left =
                inTank ? particles.v[i] : Vec(state.R.transpose() * (particles.v[i] - state.velocityAt(X[i])));
            EXPECT_LT((left - expected[i]).norm(), 1e-12) << i;
            EXPECT_NEAR(equationOfState.p(particles.rho[i]), compressed[i], 1e-6) << i;
        }
    }
}

TEST(StableTimeStep, IsTheSmallestOfTheAcousticTheAccelerationAndTheViscousLimit)
{
    EXPECT_DOUBLE_EQ(stableTimeStep(0.25, 0.01, 18, 2, 0, 0), 0.25 * 0.01 / 20);
    EXPECT_DOUBLE_EQ(stableTimeStep(0.25, 0.01, 18, 2, 10, 1e-6), 0.25 * 0.01 / 20);
    EXPECT_DOUBLE_EQ(stableTimeStep(0.25, 0.01, 18, 2, 1e6, 1e-6), 0.25 * 1e-4);
    EXPECT_DOUBLE_EQ(stableTimeStep(0.25, 0.01, 18, 2, 10, 1), 1e-4 / 8);
}

} // namespace
} // namespace slosh
