// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/blockImpact.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace slosh
{
namespace
{

constexpr double pi = std::numbers::pi;

TEST(BlockImpact, HasTheTabulatedLossAndImpulse)
{
    const std::vector<std::array<double, 3>> table = {
        {0.25, .729585, .232515}, {0.5, .5, .337657}, {1, .270415, .369716}, {2, .135688, .371224}};
    for (const auto& [ratio, loss, impulse] : table)
    {
        EXPECT_NEAR(blockImpactEnergyLoss(ratio), loss, 5e-7);
        EXPECT_NEAR(blockImpactCentreImpulse(ratio), impulse, 5e-7);
    }
}

TEST(BlockImpact, SumsItsSeriesToRounding)
{
    for (const double ratio : {0.02, 0.3, 3.0})
    {
        double loss = 0, impulse = 0;
        for (int n = 200001; n > 0; n -= 2)
        {
            const double share = std::tanh(n * pi * ratio) / (static_cast<double>(n) * n);
            loss += 8 / (pi * pi * pi) / ratio * share / n;
            impulse += 4 / (pi * pi) * (n % 4 == 1 ? 1 : -1) * share;
        }
        EXPECT_NEAR(blockImpactEnergyLoss(ratio), loss, 1e-9);
        EXPECT_NEAR(blockImpactCentreImpulse(ratio), impulse, 1e-10);
    }
}

// Thin: all stops, P = rho U H in the middle. Half as thick as long: exactly half is lost.
TEST(BlockImpact, HasItsLimits)
{
    EXPECT_NEAR(blockImpactEnergyLoss(1e-4), 1, 2e-4);
    const double fromTheEnds = 16 / (pi * pi) * std::exp(-pi / (4 * 0.05)); // cos(pi y/2H) e^(-pi x/2H), from both
    EXPECT_NEAR(blockImpactCentreImpulse(0.05) / 0.05, 1 - fromTheEnds, 1e-12);
    EXPECT_NEAR(blockImpactEnergyLoss(0.5), 0.5, 1e-15);
    EXPECT_NEAR(blockImpactEnergyLoss(20) * 20, blockImpactEnergyLoss(10) * 10, 1e-14);
}

// Laplace's equation for P on the block, by finite differences: a second method.
TEST(BlockImpact, AgreesWithARelaxedPressureImpulse)
{
    constexpr int n = 32, m = 16; // L = 1 along the wall, H = 1/2
    constexpr double dx = 1.0 / n;
    std::vector<std::array<double, n + 1>> P(m + 1);
    for (auto& row : P)
    {
        row.fill(0);
    }
    for (int sweep = 0; sweep < 2000; ++sweep)
    {
        for (int j = 0; j < m; ++j)
        {
            for (int i = 1; i < n; ++i)
            {
                const double beyond = j == 0 ? P[1][i] + 2 * dx : P[j - 1][i]; // -dP/dn = rho U = 1
                P[j][i] += 1.8 * ((beyond + P[j + 1][i] + P[j][i - 1] + P[j][i + 1]) / 4 - P[j][i]);
            }
        }
    }
    double total = 0;
    for (const double value : P[0])
    {
        total += value * dx;
    }
    EXPECT_NEAR(P[0][n / 2], blockImpactCentreImpulse(0.5), 1e-3);
    EXPECT_NEAR(total / 0.5, blockImpactEnergyLoss(0.5), 3e-3);
}

} // namespace
} // namespace slosh
