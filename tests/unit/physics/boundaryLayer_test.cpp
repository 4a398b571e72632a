// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/BoundaryLayer.hpp"

#include <gtest/gtest.h>

#include <complex>

namespace slosh
{
namespace
{

constexpr double rho = 1000, nu = 1e-6;

/// The stress at t after u has jumped from 0 to U at 0, in n steps.
double stressAfterJump(double U, double t, int n)
{
    BoundaryLayer layer;
    layer.advance(Vec(U, 0, 0), BoundaryLayer::Step(0));
    const BoundaryLayer::Step step(t / n);
    for (int k = 0; k < n; ++k)
    {
        layer.advance(Vec(U, 0, 0), step);
    }
    return layer.shearStress(rho, nu).x();
}

TEST(BoundaryLayer, OfLiquidThatComesToADryWallIsStokesFirstProblem)
{
    const double U = 0.01; // laminar all the time
    for (double t = 5e-4; t < 20; t *= 1.3)
    {
        const double exact = rho * U * std::sqrt(nu / (std::numbers::pi * t));
        EXPECT_NEAR(stressAfterJump(U, t, 10) / exact, 1, 0.02) << t;
        EXPECT_NEAR(stressAfterJump(U, t, 1) / stressAfterJump(U, t, 10), 1, 1e-12) << t; // at any step
    }
}

TEST(BoundaryLayer, OfAnOscillationIsStokesSecondProblem)
{
    const double U = 0.01;
    for (const double omega : {0.5, 2.0, 8.0, 30.0})
    {
        // tau = rho U sqrt(nu omega) cos(omega t + pi/4) of u = U cos(omega t), after 20 periods.
        BoundaryLayer layer;
        constexpr int steps = 400;
        const double dt = 2 * std::numbers::pi / omega / steps;
        const BoundaryLayer::Step step(dt);
        std::complex<double> component = 0;
        for (int k = 1; k <= 20 * steps; ++k)
        {
            layer.advance(Vec(0, U * std::cos(omega * k * dt), 0), step);
            if (k > 19 * steps)
            {
                component += layer.shearStress(rho, nu).y() * std::polar(2.0 / steps, -omega * k * dt);
            }
        }
        EXPECT_NEAR(std::abs(component) / (rho * U * std::sqrt(nu * omega)), 1, 0.03) << omega;
        EXPECT_NEAR(std::arg(component), std::numbers::pi / 4, 0.03) << omega;
    }
}

TEST(BoundaryLayer, IsTurbulentFromItsReynoldsNumberOn)
{
    BoundaryLayer layer;
    const double U = 2, dt = 1e-3;
    const BoundaryLayer::Step step(dt);
    const auto Re = [&] { return U * layer.way.norm() / nu; };
    while (Re() < 0.99 * BoundaryLayer::transition)
    {
        layer.advance(Vec(U, 0, 0), step);
    }
    const double laminar = layer.shearStress(rho, nu).x();
    while (Re() < 2e6)
    {
        layer.advance(Vec(U, 0, 0), step);
    }
    // c_f = 0.0592 (2e6)^(-1/5) = 0.003252
    EXPECT_NEAR(layer.shearStress(rho, nu).x(), 0.003252 * rho * U * U / 2, 0.01 * rho * U * U * 0.003252 / 2);
    EXPECT_GT(layer.shearStress(rho, nu).x(), 1.5 * laminar);

    // The way begins anew where the flow turns back.
    layer.advance(Vec(-U, 0, 0), step);
    EXPECT_NEAR(layer.way.x(), -U * dt, 1e-12);
}

} // namespace
} // namespace slosh
