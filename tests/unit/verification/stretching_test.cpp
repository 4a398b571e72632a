// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/StretchingDrop.hpp"
#include "verification/StretchingPatch.hpp"
#include "verification/errorNorms.hpp"
#include "verification/rungeKutta.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace slosh
{
namespace
{

template <class F>
double derivative(const F& f, double t, double d = 1e-3)
{
    return (8 * (f(t + d) - f(t - d)) - (f(t + 2 * d) - f(t - 2 * d))) / (12 * d);
}

TEST(RungeKutta4, IsOfFourthOrder)
{
    std::vector<double> steps, errors;
    for (const double step : {0.1, 0.05, 0.025, 0.0125})
    {
        steps.push_back(step);
        // s' = 1/(1 + s): s = sqrt(1 + 2t) - 1
        errors.push_back(
            std::abs(integrateRungeKutta4([](double s) { return 1 / (1 + s); }, 2, step) - (std::sqrt(5.0) - 1))
        );
    }
    const ObservedOrder order = observedOrder(steps, errors);
    EXPECT_NEAR(order.p, 4, 0.1);
    EXPECT_EQ(integrateRungeKutta4([](double) { return 1.0; }, 0, 0.1), 0);
}

// Figures from an integration of a, b and A by an eighth-order Runge-Kutta method (tolerance 1e-12).
TEST(StretchingPatch, HasTheTabulatedAxesAndPressure)
{
    const StretchingPatch patch(1, 1, 1000);
    const std::vector<std::array<double, 4>> table = {
        {0.5, .627053, 1.594763, 231.943}, {1, .439461, 2.275516, 69.327}, {2, .271814, 3.678985, 10.799}};
    for (const auto& [t, a, b, pc] : table)
    {
        const StretchedPatch now = patch.at(t);
        EXPECT_NEAR(now.a, a, 6e-7);
        EXPECT_NEAR(now.b, b, 6e-7);
        EXPECT_NEAR(now.pc, pc, 6e-4);
    }
    EXPECT_DOUBLE_EQ(patch.at(0).pc, 500);
}

TEST(StretchingPatch, KeepsAreaAndEnergyAndObeysItsEquations)
{
    const double R = 0.7, rho = 900;
    for (const double A0 : {2.0, -0.5})
    {
        const StretchingPatch patch(A0, R, rho);
        for (const double t : {0.3, 1.7})
        {
            const auto [a, b, A, pc] = patch.at(t);
            EXPECT_NEAR(a * b, R * R, 1e-14);
            EXPECT_NEAR(
                std::numbers::pi * rho * a * b * A * A * (a * a + b * b) / 8, patch.kineticEnergy(),
                1e-12 * patch.kineticEnergy()
            );
            EXPECT_NEAR(derivative([&](double s) { return patch.at(s).a; }, t), -A * a, 1e-9);
            EXPECT_NEAR(derivative([&](double s) { return patch.at(s).b; }, t), A * b, 1e-9);
            EXPECT_NEAR(
                derivative([&](double s) { return patch.at(s).A; }, t), A * A * (a * a - b * b) / (a * a + b * b), 1e-8
            );
        }
    }
}

TEST(StretchingPatch, ObeysTheEquationOfMotionAndHasNoPressureAtItsSurface)
{
    const double rho = 900, t = 0.4, x = 0.2, y = -0.3;
    const StretchingPatch patch(1.5, 0.7, rho);
    const StretchedPatch now = patch.at(t);
    const Eigen::Vector2d v = now.velocity(x, y);
    const auto along = [&](int i) { return derivative([&](double s) { return patch.at(s).velocity(x, y)[i]; }, t); };
    // dv/dt + v . grad v with grad v = diag(-A, A)
    const double ax = along(0) - now.A * v.x(), ay = along(1) + now.A * v.y();
    EXPECT_NEAR(ax, -derivative([&](double s) { return now.pressure(s, y); }, x) / rho, 1e-8);
    EXPECT_NEAR(ay, -derivative([&](double s) { return now.pressure(x, s); }, y) / rho, 1e-8);
    for (const double angle : {0.1, 1.0, 2.5})
    {
        EXPECT_NEAR(now.pressure(now.a * std::cos(angle), now.b * std::sin(angle)), 0, 1e-12 * now.pc);
    }
    EXPECT_EQ(now.pressure(0, 1.1 * now.b), 0);
}

// The same integration as above, of a, c and A.
TEST(StretchingDrop, HasTheTabulatedAxesAndPressure)
{
    const StretchedDrop drop = StretchingDrop(1, 1, 1000).at(0.5);
    EXPECT_NEAR(drop.a, 0.8046387577, 1e-10);
    EXPECT_NEAR(drop.c, 1.544536246, 1e-9);
    EXPECT_NEAR(drop.A, 0.7440737107, 1e-10);
    EXPECT_NEAR(drop.pc, 118.359182, 1e-6);
    EXPECT_DOUBLE_EQ(StretchingDrop(1, 1, 1000).at(0).pc, 250);
}

TEST(StretchingDrop, KeepsVolumeAndEnergyAndObeysItsEquations)
{
    const double R = 0.7, rho = 900;
    for (const double A0 : {2.0, -0.5})
    {
        const StretchingDrop drop(A0, R, rho);
        for (const double t : {0.3, 1.7})
        {
            const auto [a, c, A, pc] = drop.at(t);
            EXPECT_NEAR(a * a * c, R * R * R, 1e-14);
            const double energy =
                4 * std::numbers::pi / 3 * a * a * c * rho / 5 * A * A * (a * a / 4 + a * a / 4 + c * c) / 2;
            EXPECT_NEAR(energy, drop.kineticEnergy(), 1e-12 * energy);
            EXPECT_NEAR(derivative([&](double s) { return drop.at(s).a; }, t), -A * a / 2, 1e-9);
            EXPECT_NEAR(derivative([&](double s) { return drop.at(s).c; }, t), A * c, 1e-9);
        }
    }
}

TEST(StretchingDrop, ObeysTheEquationOfMotionAndHasNoPressureAtItsSurface)
{
    const double rho = 900, t = 0.4;
    const Vec r(0.2, -0.1, 0.3);
    for (const double A0 : {1.5, -1.0})
    {
        const StretchingDrop drop(A0, 0.7, rho);
        const StretchedDrop now = drop.at(t);
        const Vec gradient(-now.A / 2, -now.A / 2, now.A);
        for (int i = 0; i < 3; ++i)
        {
            const double local = derivative([&](double s) { return drop.at(s).velocity(r)[i]; }, t);
            const auto pressureAlong = [&](double s)
            {
                Vec place = r;
                place[i] = s;
                return now.pressure(place);
            };
            EXPECT_NEAR(local + gradient[i] * now.velocity(r)[i], -derivative(pressureAlong, r[i]) / rho, 1e-8);
        }
        EXPECT_NEAR(now.velocity(r).dot(gradient) + gradient.sum(), now.velocity(r).dot(gradient), 1e-15); // div v = 0
        EXPECT_NEAR(now.pressure({now.a * 0.6, 0, now.c * 0.8}), 0, 1e-12 * now.pc);
    }
}

} // namespace
} // namespace slosh
