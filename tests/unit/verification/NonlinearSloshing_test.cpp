// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/NonlinearSloshing.hpp"

#include "verification/naturalFrequencies.hpp"

#include "base/CaseError.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace slosh
{
namespace
{

constexpr double pi = std::numbers::pi;
const RectangularTank tank{.L = 1, .h = 0.5};
const double w1 = rectangularFrequency(1, 1, 0.5, 9.81);

/// Largest |f(t)| at hundredths of a second.
template <class F>
double largest(double end, const F& f)
{
    double most = 0;
    for (int i = 1; i <= std::lround(100 * end); ++i)
    {
        most = std::max(most, std::abs(f(0.01 * i)));
    }
    return most;
}

/// Mean over the tank of f(x), exact for few modes.
template <class F>
double mean(const F& f, int points = 256)
{
    double sum = 0;
    for (int j = 0; j < points; ++j)
    {
        sum += f((j + 0.5) / points - 0.5);
    }
    return sum / points;
}

SwayAndRoll::Function cosine(double A, double w)
{
    return [=](const Jet& t) { return A * cos(w * t); };
}

/// Frequency of the first mode over that of small amplitude, less 1: a straight line through the instants of twenty
/// periods at which its amplitude is 0, so that the faster waves which the pure cosine releases as well average out.
double shiftOf(const StandingWave& wave)
{
    NonlinearSloshing liquid(wave, {.modes = 24, .order = 6});
    const auto firstMode = [&](double t)
    { return mean([&](double x) { return 2 * std::cos(pi * (x + 0.5)) * liquid.eta(x, t); }, 32); };
    const double quarter = pi / 2 / wave.omega();
    double n = 0, sumI = 0, sumT = 0, sumII = 0, sumIT = 0;
    for (int i = 0; i < 40; ++i)
    {
        double early = 2 * i * quarter, late = early + 2 * quarter;
        const bool falls = firstMode(early) > 0;
        for (int halving = 0; halving < 40; ++halving)
        {
            const double middle = (early + late) / 2;
            ((firstMode(middle) > 0) == falls ? early : late) = middle;
        }
        n += 1, sumI += i, sumT += early, sumII += i * i, sumIT += i * early;
    }
    const double halfPeriod = (n * sumIT - sumI * sumT) / (n * sumII - sumI * sumI);
    return pi / halfPeriod / wave.omega() - 1;
}

TEST(NonlinearSloshing, OfAFreeWaveKeepsItsEnergyToTheFifthPowerOfTheStep)
{
    const StandingWave wave{.L = 1, .h = 0.5, .a = 0.05};
    const auto drift = [&](double step)
    {
        NonlinearSloshing liquid(wave, {.modes = 16, .order = 4, .step = step});
        const double end = 200 / step * liquid.timeStep(); // between steps, interpolation adds an error of its own
        return liquid.energy(end) / liquid.energy(0) - 1;
    };
    const double coarse = drift(0.5), fine = drift(0.25);
    EXPECT_NEAR(std::log2(coarse / fine), 5, 0.1);
    EXPECT_LT(std::abs(fine), 1e-6); // over 7 periods
}

TEST(NonlinearSloshing, ShiftsTheFrequencyByTheSquareOfTheAmplitudeAsTadjbakhshAndKellerDo)
{
    const StandingWave low{.L = 1, .h = 0.5, .a = 0.01}, high{.L = 1, .h = 0.5, .a = 0.02};
    const double shift = shiftOf(low), twice = shiftOf(high);
    EXPECT_NEAR(twice / shift, 4, 0.06);
    EXPECT_NEAR(shift / (low.frequencyRatio() - 1), 1, 0.015);
    EXPECT_NEAR(twice / (high.frequencyRatio() - 1), 1, 0.015);
    // faster where it is shallow; the next power of the amplitude is larger there
    const StandingWave shallow{.L = 1, .h = 0.25, .a = 0.01};
    EXPECT_NEAR(shiftOf(shallow) / (shallow.frequencyRatio() - 1), 1, 0.02);
}

TEST(NonlinearSloshing, ApproachesTheLinearOneByTheSquareOfTheAmplitude)
{
    for (const Start start : {Start::withTank, Start::atRest})
    {
        const auto difference = [&](double A)
        {
            const auto sway = [=](const Jet& t) { return A * sin(0.8 * w1 * t + 0.5); };
            NonlinearSloshing nonlinear(tank, sway, start, {.modes = 32, .order = 4});
            LinearSloshing linear(tank, {.sway = sway}, start, 16); // odd modes: the same
            return std::pair(
                largest(4, [&](double t) { return nonlinear.eta(-0.45, t) - linear.eta(-0.45, t); }),
                largest(4, [&](double t) { return nonlinear.pressure(-0.5, -0.1, t) - linear.pressure(-0.5, -0.1, t); })
            );
        };
        const auto [eta, p] = difference(0.0005);
        const auto [etaTwice, pTwice] = difference(0.001);
        EXPECT_NEAR(std::log2(etaTwice / eta), 2, 0.1);
        EXPECT_NEAR(std::log2(pTwice / p), 2, 0.1);
        EXPECT_LT(eta, 0.01 * 0.0024); // of the wave
    }
}

TEST(NonlinearSloshing, OfOrderOneIsTheLinearWaveToTheFourthPowerOfTheStep)
{
    const StandingWave wave{.L = 1, .h = 0.3, .n = 2, .a = 0.05};
    const auto error = [&](double step)
    {
        NonlinearSloshing liquid(wave, {.modes = 16, .order = 1, .step = step});
        return largest(3, [&](double t) { return liquid.eta(0.4, t) - wave.eta(0.4, t); });
    };
    const double coarse = error(0.5), fine = error(0.25);
    EXPECT_NEAR(std::log2(coarse / fine), 4, 0.1);
    EXPECT_LT(fine, 1e-5 * wave.a);
}

TEST(NonlinearSloshing, IsWrongByThePowerOfTheAmplitudeAfterItsOrder)
{
    for (int M = 1; M <= 5; ++M)
    {
        const auto error = [M](double a)
        {
            const StandingWave wave{.L = 1, .h = 0.5, .a = a};
            NonlinearSloshing liquid(wave, {.modes = 20, .order = M}), better(wave, {.modes = 20, .order = 9});
            return largest(1, [&](double t) { return liquid.eta(-0.5, t) - better.eta(-0.5, t); });
        };
        EXPECT_NEAR(std::log2(error(0.02) / error(0.01)), M + 1, 0.2) << M;
    }
}

TEST(NonlinearSloshing, ConvergesExponentiallyInTheModesOfASmoothWave)
{
    const StandingWave wave{.L = 1, .h = 0.5, .a = 0.05};
    const double dt = 0.01;
    const auto liquid = [&](int N)
    {
        const double step = dt * std::sqrt(9.81 * N * pi); // the same for all
        return NonlinearSloshing(wave, {.modes = N, .order = 5, .step = step});
    };
    NonlinearSloshing best = liquid(32);
    std::vector<double> error;
    for (const int N : {6, 12, 18})
    {
        NonlinearSloshing coarse = liquid(N);
        error.push_back(largest(1, [&](double t) { return coarse.eta(-0.5, t) - best.eta(-0.5, t); }));
    }
    EXPECT_LT(error[1], error[0] / 100);
    EXPECT_LT(error[2], error[1] / 100);
}

TEST(LongNonlinearSloshing, OfASwayingTankConvergesAsItsKinksAtTheWallsLetIt)
{
    const auto sway = cosine(0.002, 0.8 * w1);
    const auto liquid = [&](int N) { return NonlinearSloshing(tank, sway, Start::withTank, {.modes = N, .order = 3}); };
    NonlinearSloshing best = liquid(128);
    const auto error = [&](int N)
    {
        NonlinearSloshing coarse = liquid(N);
        double overSurface = 0, atWall = 0;
        for (int i = 1; i <= 100; ++i)
        {
            const double t = 0.04 * i;
            const auto square = [&](double x) { return std::pow(coarse.eta(x, t) - best.eta(x, t), 2); };
            overSurface += mean(square, 64);
            atWall += square(-0.5);
        }
        return std::pair(std::sqrt(overSurface), std::sqrt(atWall));
    };
    const auto coarse = error(12), fine = error(24);
    EXPECT_NEAR(std::log2(coarse.first / fine.first), 1.5, 0.3);
    EXPECT_NEAR(std::log2(coarse.second / fine.second), 1, 0.3);
}

TEST(NonlinearSloshing, KeepsItsMassAndGainsTheEnergyThatTheTankGives)
{
    const auto sway = cosine(0.005, w1);
    NonlinearSloshing liquid(tank, sway, Start::withTank, {.modes = 24, .order = 5});
    const auto moment = [&](double t) { return mean([&](double x) { return x * liquid.eta(x, t); }); };
    // - rho X'' d/dt integral x eta dx, by parts: the trapezoidal rule of rho X''' integral x eta dx
    const int steps = 1000;
    const double end = 5, dt = end / steps;
    double work = -1000 * sway(Jet::time(end)).dd * moment(end);
    for (int i = 1; i <= steps; ++i)
    {
        const double t = i * dt, rateOfAcceleration = 0.005 * std::pow(w1, 3) * std::sin(w1 * t);
        work += (i < steps ? 1 : 0.5) * dt * 1000 * rateOfAcceleration * moment(t);
    }
    EXPECT_NEAR(liquid.energy(end), work, 2e-3 * work);
    EXPECT_GT(work, 5);
    for (const double t : {1.0, 3.0, 5.0})
    {
        EXPECT_NEAR(mean([&](double x) { return liquid.eta(x, t); }), 0, 1e-15);
    }
}

// Newton's second law for all of the liquid, per metre of breadth: what the bottom carries above rho g h L is
// rho d^2/dt^2 integral eta^2/2 dx.
TEST(NonlinearSloshing, PressesOnTheBottomWhatItsVerticalMotionNeeds)
{
    NonlinearSloshing liquid(StandingWave{.L = 1, .h = 0.5, .a = 0.05}, {.modes = 20, .order = 6});
    const auto height = [&](double t) { return mean([&](double x) { return std::pow(liquid.eta(x, t), 2) / 2; }, 64); };
    const double d = liquid.timeStep();
    for (const int n : {10, 50, 100})
    {
        const double t = n * d;
        const double acceleration =
            (-height(t + 2 * d) + 16 * height(t + d) - 30 * height(t) + 16 * height(t - d) - height(t - 2 * d)) /
            (12 * d * d);
        const double carried = mean([&](double x) { return liquid.pressure(x, -0.5, t); }, 64) - 1000 * 9.81 * 0.5;
        EXPECT_NEAR(carried, 1000 * acceleration, 0.01) << t;
        EXPECT_GT(std::abs(carried), 5) << t;
    }
}

TEST(NonlinearSloshing, IsTheSameInWhateverOrderItIsAsked)
{
    NonlinearSloshing one(tank, cosine(0.005, w1), Start::withTank, {.modes = 16});
    const double late = one.eta(0.3, 2), early = one.eta(0.3, 0.7);
    NonlinearSloshing other(one);
    EXPECT_EQ(other.eta(0.3, 0.7), early);
    EXPECT_EQ(other.eta(0.3, 2), late);
    EXPECT_EQ(NonlinearSloshing(tank, cosine(0.005, w1), Start::withTank, {.modes = 16}).eta(0.3, 0.7), early);
    EXPECT_EQ(one.eta(0.3, 0), 0);
}

TEST(NonlinearSloshing, SaysWhenItCannotGoOn)
{
    NonlinearSloshing liquid(tank, cosine(0.02, w1), Start::withTank, {.modes = 24});
    EXPECT_THROW(liquid.eta(0, 20), CaseError);
    EXPECT_NE(liquid.eta(-0.5, 1), 0); // what was before stays
    EXPECT_THROW(liquid.eta(0, -0.1), CaseError);
    EXPECT_THROW(liquid.pressure(-0.5, 0, 1), CaseError);
    EXPECT_THROW(NonlinearSloshing(tank, {}, Start::withTank, {.modes = 0}), CaseError);
    EXPECT_THROW(NonlinearSloshing(tank, {}, Start::withTank, {.order = 0}), CaseError);
    EXPECT_THROW(NonlinearSloshing(tank, {}, Start::withTank, {.step = 0}), CaseError);
    EXPECT_THROW(NonlinearSloshing(StandingWave{.n = 9}, {.modes = 8}), CaseError);
}

} // namespace
} // namespace slosh
