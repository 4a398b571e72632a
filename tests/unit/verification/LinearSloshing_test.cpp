// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/BoxSloshing.hpp"
#include "verification/LinearSloshing.hpp"
#include "verification/StandingWave.hpp"
#include "verification/equilibria.hpp"
#include "verification/naturalFrequencies.hpp"

#include "base/CaseError.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace slosh
{
namespace
{

constexpr double pi = std::numbers::pi;
const RectangularTank tank{.L = 0.9, .h = 0.25, .g = 9.81, .rho = 998};

SwayAndRoll::Function sine(double amplitude, double w)
{
    return [=](const Jet& t) { return amplitude * sin(w * t); };
}

/// Rises smoothly from 0 to 1 over about `duration`, its derivatives being nothing at 0.
Jet ramp(const Jet& t, double duration)
{
    const Jet u = t / duration;
    return 1 - exp(-1.0 * u * u * u * u);
}

/// A motion of all kinds at once that begins softly.
SwayAndRoll everything()
{
    return {
        .sway = [](const Jet& t) { return 0.01 * ramp(t, 1) * sin(3.1 * t); },
        .roll = [](const Jet& t) { return 0.02 * ramp(t, 1) * cos(2.3 * t); },
        .pivot = 0.17};
}

/// beta'' + omega^2 beta = f sin w t from beta = 0, beta' = rate.
double response(double omega, double w, double f, double rate, double t)
{
    const double forced = std::abs(omega - w) < 1e-9
                              ? (std::sin(w * t) - w * t * std::cos(w * t)) / (2 * w * w)
                              : (std::sin(w * t) - w / omega * std::sin(omega * t)) / (omega * omega - w * w);
    return f * forced + rate / omega * std::sin(omega * t);
}

/// eta of X = A sin w t and theta = theta0 sin w t in closed form.
double closedForm(double A, double theta0, double y0, double w, bool jump, double x, double t, int modes)
{
    double eta = 0;
    for (int n = 1; n < 2 * modes; n += 2)
    {
        const double k = n * pi / tank.L, omega = rectangularFrequency(n, tank.L, tank.h, tank.g);
        const double s = 4 * std::tanh(k * tank.h) / (tank.L * k), d = 2 / k * std::tanh(k * tank.h / 2);
        const double f = s * (-A * w * w + tank.g * theta0 - (y0 + d) * theta0 * w * w);
        const double rate = jump ? s * w * (A + (y0 + d) * theta0) : 0;
        eta += response(omega, w, f, rate, t) * std::cos(k * (x + tank.L / 2));
    }
    return eta;
}

TEST(LinearSloshing, AgreesWithTheClosedFormOfHarmonicMotion)
{
    const double omega1 = rectangularFrequency(1, tank.L, tank.h, tank.g);
    for (const double w : {0.6 * omega1, omega1, 2.3 * omega1})
    {
        for (const Start start : {Start::withTank, Start::atRest})
        {
            const bool jump = start == Start::atRest;
            LinearSloshing sway(tank, {.sway = sine(0.003, w)}, start);
            LinearSloshing roll(tank, {.roll = sine(0.01, w), .pivot = -0.1}, start);
            for (const double t : {0.01, 0.4, 3.0, 20.0})
            {
                for (const double x : {-0.45, -0.2, 0.45})
                {
                    EXPECT_NEAR(sway.eta(x, t), closedForm(0.003, 0, 0, w, jump, x, t, 100), 1e-10);
                    EXPECT_NEAR(roll.eta(x, t), closedForm(0, 0.01, -0.1, w, jump, x, t, 100), 1e-10);
                }
            }
        }
    }
}

TEST(LinearSloshing, DoesNotDependOnWhatWasAskedBefore)
{
    LinearSloshing forward(tank, everything()), back(tank, everything());
    const double late = back.eta(0.1, 2.71);
    const double early = back.eta(0.1, 0.333);
    EXPECT_EQ(forward.eta(0.1, 0.333), early);
    EXPECT_EQ(forward.eta(0.1, 2.71), late);
    EXPECT_NE(early, late);
}

TEST(LinearSloshing, RefusesTimesBeforeItBeginsAndSumsOfNothing)
{
    LinearSloshing liquid(tank, everything());
    EXPECT_THROW(liquid.eta(0.1, -0.01), CaseError);
    EXPECT_THROW(liquid.pressure(0.1, -0.1, std::nan("")), CaseError);
    EXPECT_THROW(LinearSloshing(tank, everything(), Start::withTank, 0), CaseError);
}

TEST(LinearSloshing, IsAntisymmetricSoThatNoLiquidIsLost)
{
    LinearSloshing liquid(tank, everything());
    EXPECT_NEAR(liquid.eta(-0.31, 1.9), -liquid.eta(0.31, 1.9), 1e-15);
    EXPECT_GT(std::abs(liquid.eta(0.31, 1.9)), 1e-3);
}

TEST(LinearSloshing, StaysLevelInATankAtRest)
{
    LinearSloshing liquid(tank);
    EXPECT_EQ(liquid.eta(0.3, 5), 0);
    EXPECT_NEAR(liquid.pressure(0.3, -0.1, 5), tank.rho * tank.g * 0.1, 1e-12);
}

/// Pressure divided by rho, and its derivatives by differences.
struct PressureField
{
    LinearSloshing& liquid;
    double t, d;

    double p(double x, double y) const { return liquid.pressure(x, y, t) / tank.rho; }
    double px(double x, double y) const { return (p(x + d, y) - p(x - d, y)) / (2 * d); }
    double py(double x, double y) const { return (p(x, y + d) - p(x, y - d)) / (2 * d); }
    double laplacian(double x, double y) const
    {
        return (p(x + d, y) + p(x - d, y) + p(x, y + d) + p(x, y - d) - 4 * p(x, y)) / (d * d);
    }
};

TEST(LinearSloshing, HasAHarmonicPressureThatMovesTheLiquidWithTheWalls)
{
    const SwayAndRoll motion = everything();
    LinearSloshing liquid(tank, motion);
    const double t = 2.2;
    const Jet X = motion.sway(Jet::time(t)), theta = motion.roll(Jet::time(t));
    const PressureField field{liquid, t, 1e-3};
    EXPECT_NEAR(field.laplacian(0.2, -0.12), 0, 1e-3);
    EXPECT_NEAR(field.laplacian(-0.31, -0.2), 0, 1e-3);
    EXPECT_GT(std::abs(field.px(0.2, -0.12)), 0.01);
    for (const double x : {-tank.L / 2, tank.L / 2})
    {
        for (const double y : {-0.22, -0.1}) // the formulas continue beyond the wall, smoothly below the surface
        {
            EXPECT_NEAR(-field.px(x, y), X.dd + tank.g * theta.f - (y - motion.pivot) * theta.dd, 1e-5);
        }
    }
    for (const double x : {-0.3, 0.1})
    {
        EXPECT_NEAR(-field.py(x, -tank.h), tank.g + theta.dd * x, 1e-5);
        EXPECT_NEAR(field.p(x, 0), tank.g * liquid.eta(x, t), 2e-5); // the sums end
        EXPECT_NEAR(field.p(x, 0.01), field.p(x, 0) - tank.g * 0.01, 1e-14);
    }
}

// Horizontal momentum: the walls push the liquid's centre of mass. Joins pressure and elevation.
TEST(LinearSloshing, PushesItsMassByTheWallPressure)
{
    const SwayAndRoll motion = {.sway = [](const Jet& t) { return 0.01 * ramp(t, 1) * sin(3.1 * t); }};
    LinearSloshing liquid(tank, motion);
    const auto integral = [](double begin, double end, const auto& f) // Simpson's rule
    {
        constexpr int intervals = 2000;
        double sum = f(begin) + f(end);
        for (int i = 1; i < intervals; ++i)
        {
            sum += (i % 2 == 1 ? 4 : 2) * f(begin + (end - begin) * i / intervals);
        }
        return sum * (end - begin) / (3 * intervals);
    };
    const auto moment = [&](double t)
    { return integral(-tank.L / 2, tank.L / 2, [&](double x) { return x * liquid.eta(x, t); }); };
    for (const double t : {1.3, 2.0})
    {
        const double d = 0.01;
        const double shifted = (moment(t + d) - 2 * moment(t) + moment(t - d)) / (d * d);
        const double push = integral(
            -tank.h, 0, [&](double y) { return liquid.pressure(-tank.L / 2, y, t) - liquid.pressure(tank.L / 2, y, t); }
        );
        const double expected = tank.rho * (tank.L * tank.h * motion.sway(Jet::time(t)).dd + shifted);
        EXPECT_NEAR(push, expected, 2e-3 * std::abs(expected));
        EXPECT_GT(std::abs(shifted), 0.1 * tank.L * tank.h * std::abs(motion.sway(Jet::time(t)).dd));
    }
}

TEST(LinearSloshing, FollowsASlowMotionAsATiltedLevel)
{
    // X'' = 0.05 (1 - e^-u^4), u = t/20: integrated it is no formula, its second derivative alone matters
    const auto accelerate = [](const Jet& t) { return Jet(0, 0, 0.05 * ramp(t, 20).f); };
    LinearSloshing sway(tank, {.sway = accelerate});
    LinearSloshing roll(tank, {.roll = [](const Jet& t) { return 0.01 * ramp(t, 20); }, .pivot = 0.3});
    const double t = 60;
    const TiltedLevel level(tank.L, tank.h, 0.05, 0, tank.g);
    for (const double x : {-0.4, 0.25})
    {
        EXPECT_NEAR(sway.eta(x, t), level.eta(x) - tank.h, 4e-5);
        EXPECT_NEAR(sway.pressure(x, -0.1, t), level.pressure(x, tank.h - 0.1, tank.rho), 0.05);
        EXPECT_NEAR(roll.eta(x, t), -0.01 * x, 8e-5);
        EXPECT_NEAR(roll.pressure(x, -0.1, t), tank.rho * tank.g * (0.1 - 0.01 * x), 0.1);
    }
}

TEST(LinearSloshing, SwaysWhereItRollsAboutAPointFarAbove)
{
    const double far = 1e6, w = 3;
    LinearSloshing sway(tank, {.sway = sine(0.01, w)}, Start::atRest);
    LinearSloshing roll(tank, {.roll = sine(0.01 / far, w), .pivot = far}, Start::atRest);
    for (const double t : {0.1, 1.0, 2.5})
    {
        EXPECT_NEAR(sway.eta(0.45, t), roll.eta(0.45, t), 1e-6);
        EXPECT_NEAR(sway.pressure(0.45, -0.1, t), roll.pressure(0.45, -0.1, t), 0.01);
    }
}

// sum_odd cos(n a)/n = log(cot(a/2))/2
TEST(LinearSloshing, StartedFromRestRisesAtTheWallThatPushes)
{
    const RectangularTank deep{.L = 1, .h = 5};
    const double U = 0.02, dt = 1e-6;
    LinearSloshing liquid(deep, {.sway = [U](const Jet& t) { return U * t; }}, Start::atRest, 5000);
    for (const double part : {0.1, 0.25, 0.6})
    {
        const double rise = 2 / pi * U * std::log(1 / std::tan(pi * part / 2));
        EXPECT_NEAR(liquid.eta(part - 0.5, dt) / dt, rise, 1e-3 * U);
    }
}

TEST(BoxSloshing, AddsTwoWavesAndCountsTheDepthOnce)
{
    const SwayAndRoll motion = everything();
    LinearSloshing one(tank, motion);
    BoxSloshing both(one, LinearSloshing(tank, motion)), single(one, LinearSloshing(tank));
    EXPECT_NEAR(both.eta(0.3, 0.3, 1.7), 2 * one.eta(0.3, 1.7), 1e-15);
    EXPECT_NEAR(both.eta(-0.3, 0.3, 1.7), 0, 1e-15);
    EXPECT_NEAR(single.pressure(0.3, 0.1, -0.1, 1.7), one.pressure(0.3, -0.1, 1.7), 1e-9);
}

TEST(StandingWave, BeginsWithItsAmplitudeAndSwingsAtItsFrequency)
{
    const StandingWave wave{.L = 1, .h = 0.5, .n = 2, .a = 0.01};
    EXPECT_DOUBLE_EQ(wave.eta(-0.5, 0), 0.01);
    EXPECT_NEAR(wave.eta(-0.25, 0.3), 0, 1e-17);
    EXPECT_NEAR(wave.eta(0.5, pi / rectangularFrequency(2, 1, 0.5, 9.81)), -0.01, 1e-15);
    EXPECT_NEAR(wave.pressure(0.3, 0, 0.1), 9810 * wave.eta(0.3, 0.1), 1e-9);
    // vertical acceleration of the surface: eta_tt = -(p_y/rho + g)
    const double d = 1e-4, t = 0.1, x = 0.3;
    const double eta_tt = (wave.eta(x, t + d) - 2 * wave.eta(x, t) + wave.eta(x, t - d)) / (d * d);
    EXPECT_NEAR(eta_tt, -(wave.pressure(x, d, t) - wave.pressure(x, -d, t)) / (2 * d) / 1000 - 9.81, 1e-5);
}

TEST(StandingWave, OfFiniteAmplitudeIsSlowerInDeepLiquidAndFasterInShallow)
{
    const auto shift = [](double h)
    { return StandingWave{.L = 1, .h = h, .n = 1, .a = 0.1 / pi}.frequencyRatio() - 1; };
    // deep: w2 = (9 - 12 - 3 - 2)/32 = -1/4, omega = omega0 (1 - (k a)^2/8) (Rayleigh 1915)
    EXPECT_NEAR(shift(10), -0.01 / 8, 1e-9);
    EXPECT_LT(shift(1.07 / pi), 0); // the depth where it changes sign is k h = 1.06 (Tadjbakhsh & Keller)
    EXPECT_GT(shift(1.05 / pi), 0);
}

} // namespace
} // namespace slosh
