// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/ViscousStandingWave.hpp"
#include "verification/errorNorms.hpp"
#include "verification/naturalFrequencies.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace slosh
{
namespace
{

using Complex = std::complex<double>;
constexpr double pi = std::numbers::pi;

TEST(ViscousStandingWave, HasRootsOfItsDispersionRelation)
{
    for (const double nu : {1e-6, 0.005, 0.05, 0.5})
    {
        const ViscousStandingWave wave(pi, 1, 1, nu);
        const auto [first, second] = wave.gravityRoots();
        EXPECT_LT(std::abs(wave.dispersion(first)), 1e-12 * pi);
        EXPECT_LT(std::abs(wave.dispersion(second)), 1e-12 * pi);
        EXPECT_NE(first, second);
        EXPECT_LT(first.real(), 0);
        EXPECT_GE(wave.frequency(), 0);
        EXPECT_LE(-wave.vorticityRoots().front(), nu * (pi * pi + 4 * pi * pi));
        EXPECT_GE(-wave.vorticityRoots().front(), nu * (pi * pi + pi * pi));
    }
}

// s = i omega - 2 nu k^2 + O(nu^1.5): the shear layer at the surface is sqrt(nu/omega) thick
TEST(ViscousStandingWave, TendsToTheWeaklyDampedInviscidWave)
{
    const double k = 4, h = 0.4, g = 9.81;
    std::vector<double> viscosities, differences;
    for (const double nu : {4e-5, 2e-5, 1e-5, 5e-6})
    {
        const Complex weak(-2 * nu * k * k, waveFrequency(k, h, g));
        viscosities.push_back(nu);
        differences.push_back(std::abs(ViscousStandingWave(k, h, g, nu).gravityRoots().first - weak));
    }
    EXPECT_NEAR(observedOrder(viscosities, differences).p, 1.5, 0.02);
    EXPECT_LT(differences.back(), 0.01 * 2 * viscosities.back() * k * k);
}

// Lamb, art. 349: where viscosity is strong the surface creeps back at the rate g/(2 nu k), whatever the inertia.
TEST(ViscousStandingWave, CreepsBackWhereViscosityIsStrong)
{
    const double k = 3, g = 9.81;
    std::vector<double> viscosities, differences;
    for (const double nu : {20.0, 40.0, 80.0})
    {
        const ViscousStandingWave wave(k, 10, g, nu);
        EXPECT_EQ(wave.frequency(), 0);
        viscosities.push_back(1 / nu);
        differences.push_back(std::abs(wave.decayRate() / (g / (2 * nu * k)) - 1));
    }
    EXPECT_LT(differences.back(), 1e-4);
    EXPECT_NEAR(observedOrder(viscosities, differences).p, 2, 0.05); // in g/(nu^2 k^3)
    // the faster of the two: 0.91 nu k^2 (Lamb)
    EXPECT_NEAR(-ViscousStandingWave(k, 10, g, 80).gravityRoots().second.real() / (80 * k * k), 0.91, 0.005);
}

/// The inverse Laplace transform on Talbot's contour (Abate & Valko 2004).
template <class F>
double talbot(const F& transform, double t)
{
    constexpr int M = 24;
    const double r = 2.0 * M / (5 * t);
    double sum = 0.5 * std::exp(r * t) * transform(r).real();
    for (int j = 1; j < M; ++j)
    {
        const double angle = j * pi / M, cot = 1 / std::tan(angle);
        const Complex s = r * angle * Complex(cot, 1);
        const Complex turn(1, angle + (angle * cot - 1) * cot);
        sum += (std::exp(t * s) * transform(s) * turn).real();
    }
    return sum * r / M;
}

TEST(ViscousStandingWave, FallsFromRestAsTheInvertedTransform)
{
    const auto transformOf = [](const ViscousStandingWave& wave)
    { return [&wave](Complex s) { return 1.0 / s * (1.0 - pi * std::tanh(pi) / wave.dispersion(s)); }; };
    const ViscousStandingWave creeping(pi, 1, 1, 0.5); // all poles real: the contour serves at any time
    EXPECT_NEAR(creeping.eta(10), talbot(transformOf(creeping), 10), 1e-11);
    for (const double nu : {0.005, 0.05, 0.2, 0.5})
    {
        const ViscousStandingWave wave(pi, 1, 1, nu);
        EXPECT_NEAR(wave.eta(0), 1, 1e-9); // the sum of all residues
        // from rest: eta = 1 - g k tanh(k h) t^2/2 + ..., less by the viscosity that acts at once
        EXPECT_NEAR((wave.eta(1e-3) - 1) / 1e-6, -pi * std::tanh(pi) / 2, 0.1);
        for (const double t : {0.3, 1.0, 2.0})
        {
            EXPECT_NEAR(wave.eta(t), talbot(transformOf(wave), t), 1e-8) << "nu " << nu << ", t " << t;
        }
    }
}

TEST(ViscousStandingWave, SetInMotionFallsAsTheRateOfTheOneReleasedFromRest)
{
    for (const double nu : {0.005, 0.05, 0.5})
    {
        const ViscousStandingWave wave(pi, 1, 1, nu);
        EXPECT_NEAR(wave.etaSetInMotion(0), 0, 1e-7);
        EXPECT_NEAR(wave.etaSetInMotion(1e-4) / 1e-4, 1, 0.01); // 1 - 4 nu k^2 t ... : viscosity acts at once
        for (const double t : {0.3, 1.0, 2.0})
        {
            // Two independent ways: the transform 1/D on the contour, and the derivative, since d eta/dt of the start
            // from rest has the transform -g k tanh(k h)/D.
            EXPECT_NEAR(wave.etaSetInMotion(t), talbot([&](Complex s) { return 1.0 / wave.dispersion(s); }, t), 1e-8);
            constexpr double e = 1e-4;
            EXPECT_NEAR(
                wave.etaSetInMotion(t), -(wave.eta(t + e) - wave.eta(t - e)) / (2 * e) / (pi * std::tanh(pi)), 1e-7
            );
        }
    }
}

// Dissipation in Stokes layers, sqrt(nu omega/2) rho U^2/2 a unit of wall, by quadrature of the first-order wave.
TEST(DecayBetweenWalls, IsHalfTheDissipationOverTheEnergy)
{
    const double L = 0.8, B = 0.1, h = 0.3, g = 9.81, nu = 1e-6, k = pi / L;
    const double omega = waveFrequency(k, h, g), unit = omega / std::sinh(k * h); // amplitude 1, rho 1
    constexpr int n = 400;
    double bottom = 0, ends = 0, sides = 0;
    for (int i = 0; i < n; ++i)
    {
        const double x = (i + 0.5) * L / n, y = (i + 0.5) * h / n; // y from the bottom
        bottom += std::pow(unit * std::sin(k * x), 2) * B * L / n;
        ends += 2 * std::pow(unit * std::sinh(k * y), 2) * B * h / n;
        for (int j = 0; j < n; ++j)
        {
            const double z = (j + 0.5) * h / n;
            sides += 2 *
                     (std::pow(unit * std::cosh(k * z) * std::sin(k * x), 2) +
                      std::pow(unit * std::sinh(k * z) * std::cos(k * x), 2)) *
                     L / n * h / n;
        }
    }
    const double energy = g * L * B / 4, dissipation = std::sqrt(nu * omega / 2) / 2 * (bottom + ends + sides);
    EXPECT_NEAR(decayRateBetweenWalls(k, h, L, B, g, nu), 2 * nu * k * k + dissipation / (2 * energy), 1e-7);
    const double infinite = std::numeric_limits<double>::infinity();
    EXPECT_LT(decayRateBetweenWalls(k, h, L, infinite, g, nu), decayRateBetweenWalls(k, h, L, B, g, nu));
}

} // namespace
} // namespace slosh
