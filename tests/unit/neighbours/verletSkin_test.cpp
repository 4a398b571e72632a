// SPDX-License-Identifier: GPL-3.0-or-later
#include "randomParticles.hpp"

#include "neighbours/VerletSkin.hpp"
#include "neighbours/sortByBrick.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace slosh
{
namespace
{

/// The skin holds at least the step it is chosen for, and of the model's costs, rows of (1 + s/R)^2 and a rebuild
/// of 2.4 sums every s/closing steps, its own is within 5 % of the least.
TEST(VerletSkin, OfLeastCostHoldsAStepAndIsWorthTheLongerRows)
{
    constexpr double R = 0.04;
    for (const double closing : {1e-5 * R, 1e-3 * R, 0.01 * R, 0.1 * R, 0.3 * R})
    {
        const double skin = VerletSkin::cheapest(R, closing);
        EXPECT_GE(skin, closing);
        EXPECT_GE(skin, 0.02 * R);
        EXPECT_LE(skin, 0.3 * R);
        if (skin > 0.021 * R && skin < 0.29 * R)
        {
            const auto cost = [&](double s) { return std::pow(1 + s / R, 2) + 2.4 * closing / s; };
            double least = cost(skin);
            for (double s = 0.02 * R; s < 0.3 * R; s *= 1.02)
            {
                least = std::min(least, cost(s));
            }
            EXPECT_LT(cost(skin), 1.05 * least);
            EXPECT_GT(cost(3 * skin), 1.05 * least);
        }
    }
}

double largestSpeed(const Particles& particles)
{
    double largest = 0;
    for (std::ptrdiff_t i = 0; i < particles.nFluid; ++i)
    {
        largest = std::max(largest, particles.v[i].norm());
    }
    return largest;
}

TEST(VerletSkin, ListsHoldEveryPairWithinTheSupportUntilTheyAreToBeRebuilt)
{
    constexpr double R = 0.2, dt = 1e-3;
    for (const bool wallsMove : {false, true})
    {
        Particles particles = randomParticles(2, 400, 100, 6);
        std::mt19937 random(2);
        std::uniform_real_distribution<double> x(-1, 1);
        for (std::ptrdiff_t i = 0; i < (wallsMove ? particles.size() : particles.nFluid); ++i)
        {
            // One in twenty is ten times as fast.
            particles.v[i] = (i % 20 == 0 ? 5.0 : 0.5) * Vec(x(random), 0, x(random));
        }
        VerletSkin skin;
        EXPECT_TRUE(skin.mustRebuild(particles, dt, largestSpeed(particles)));
        Clusters liquid = sortByBrick(particles, 3 * R);
        skin.choose(particles, wallsMove, R, dt);
        ClusterLists lists;
        lists.build(particles, std::move(liquid), std::array{0, 2}, R, skin.skins(), wallsMove);
        const ListedPairs listed(lists, particles.nFluid);
        skin.listBuilt(particles);
        int steps = 0;
        for (; !skin.mustRebuild(particles, dt, largestSpeed(particles)); ++steps)
        {
            for (std::size_t i = 0; i < particles.r.size(); ++i)
            {
                particles.r[i] += dt * particles.v[i];
            }
            for (std::ptrdiff_t i = 0; i < particles.nFluid; ++i)
            {
                for (std::ptrdiff_t j = 0; j < particles.size(); ++j)
                {
                    const Vec apart = particles.r[i] - particles.r[j];
                    ASSERT_TRUE(
                        i == j || apart.norm() >= R || listed.given(static_cast<int>(i), static_cast<int>(j)) == 1
                    ) << i
                      << " and " << j << " after " << steps + 1 << " steps";
                }
            }
        }
        EXPECT_GE(steps, 5);
        skin.forget();
        EXPECT_TRUE(skin.mustRebuild(particles, dt, largestSpeed(particles)));
    }
}

TEST(VerletSkin, OfAFewFastParticlesDoesNotWidenThatOfTheBulk)
{
    constexpr double R = 0.2, dt = 1e-4;
    Particles particles = randomParticles(2, 1000, 0, 6);
    std::fill(particles.v.begin(), particles.v.end(), Vec(0.5, 0, 0));
    VerletSkin calm, spray;
    calm.choose(particles, false, R, dt);
    particles.v[17] = Vec(0, 0, 5);
    spray.choose(particles, false, R, dt);
    EXPECT_GT(spray.skins()[17], 4 * calm.skins()[17]);
    EXPECT_NEAR(spray.skins()[3] - dt * 5 / 2, calm.skins()[3] - dt * 0.5 / 2, 0.02 * calm.skins()[3]);
    // Ten times as fast, it halves the steps between rebuilds; with one skin for all they would be a tenth.
    const auto stepsUntilRebuild = [&](VerletSkin& skin, Particles moving)
    {
        skin.listBuilt(moving);
        int steps = 0;
        for (; !skin.mustRebuild(moving, dt, largestSpeed(moving)); ++steps)
        {
            for (std::size_t i = 0; i < moving.r.size(); ++i)
            {
                moving.r[i] += dt * moving.v[i];
            }
        }
        return steps;
    };
    Particles without = particles;
    without.v[17] = Vec(0.5, 0, 0);
    EXPECT_GE(stepsUntilRebuild(spray, particles), stepsUntilRebuild(calm, without) * 0.4);
}

} // namespace
} // namespace slosh
