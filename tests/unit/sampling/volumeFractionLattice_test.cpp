// SPDX-License-Identifier: GPL-3.0-or-later
// The lattice on which the free surface is looked for, on still water.
#include "sampling/volumeFractionLattice.hpp"

#include "sampling/samplePoint.hpp"

#include "dictionary/Dictionary.hpp"
#include "filling/fillTank.hpp"

#include <gtest/gtest.h>

namespace slosh
{
namespace
{

constexpr double dx = 0.02, rho0 = 1000;

/// Water 0.3 m deep in a tank of 0.61 m x 0.2 m x 3 m.
struct StillWater
{
    Scene scene;
    Particles particles;

    static Scene sceneIn(const std::string& plane)
    {
        const std::string text = "type box; " + plane + " min (0 0 0); max (0.61 0.2 3); fillDepth 0.3;";
        const Kernel kernel(ImprovedGaussian(), plane.empty() ? 3 : 2, dx);
        const TaitEquation equationOfState{rho0, 300, 7};
        return {
            Tank::read(Dictionary::parse(text, "constant/tankProperties")),
            kernel,
            SolidBodyMotion::stationary(),
            Vec(0, 0, -9.81),
            equationOfState,
            {}};
    }

    explicit StillWater(const std::string& plane)
        : scene(sceneIn(plane)), particles(fillTank(scene.tank, dx, 3, rho0, scene.equationOfState, 9.81, 3).particles)
    {
    }
    Snapshot snapshot() const { return {scene, particles, {}}; }
};

TEST(VolumeFractionLattice, HoldsTheVolumeFractionAtItsPoints)
{
    for (const char* plane : {"plane xz;", ""})
    {
        const StillWater water(plane);
        const Snapshot snapshot = water.snapshot();
        const LatticeField lattice = volumeFractionLattice(snapshot, dx);
        const auto [n0, n1, n2] = lattice.points;
        ASSERT_EQ(lattice.values.size(), static_cast<std::size_t>(n0) * n1 * n2);
        for (std::size_t i = 0; i < lattice.values.size(); i += 7)
        {
            const double F = volumeFraction(snapshot, lattice.point(static_cast<std::ptrdiff_t>(i)));
            EXPECT_EQ(lattice.values[i], static_cast<float>(F));
        }
        EXPECT_NEAR(lattice.values.front(), 1, 0.01) << "in the tank's corner";
        EXPECT_EQ(lattice.values.back(), 0) << "above the liquid";
    }
}

TEST(VolumeFractionLattice, EndsOnTheFacesOfTheWallsAndASupportAboveTheLiquid)
{
    for (const char* plane : {"plane xz;", "plane yz;", ""})
    {
        const StillWater water(plane);
        const LatticeField lattice = volumeFractionLattice(water.snapshot(), dx);
        const Vec last = lattice.point(static_cast<std::ptrdiff_t>(lattice.values.size()) - 1);
        for (const int d : water.scene.tank.directions())
        {
            EXPECT_EQ(lattice.origin[d], 0);
            EXPECT_LE(lattice.step[d], dx);
            EXPECT_GT(lattice.step[d], 0.95 * dx);
            if (d < 2)
            {
                EXPECT_NEAR(last[d], water.scene.tank.box().max()[d], 1e-12);
            }
        }
        EXPECT_GE(last.z(), 0.3 + 3 * dx - 1e-12);
        EXPECT_LE(last.z(), 0.3 + 4 * dx + 1e-12);
        if (const int d = water.scene.tank.emptyDirection(); d >= 0)
        {
            EXPECT_EQ(lattice.points[d], 1);
            EXPECT_EQ(lattice.origin[d], water.scene.tank.box().center()[d]);
        }
    }
}

TEST(VolumeFractionLattice, HasNoPointsWithoutLiquid)
{
    StillWater water("plane xz;");
    water.particles.resize(0, 0);
    EXPECT_TRUE(volumeFractionLattice(water.snapshot(), dx).values.empty());
}

TEST(LiquidMean, IsTheVelocityThatAllShareAndThePressureCarriedToThePoint)
{
    StillWater water("plane xz;");
    const Vec U(0.1, 0, -0.3);
    std::fill(water.particles.v.begin(), water.particles.v.end(), U);
    const LiquidMean atSurface = liquidMean(water.snapshot(), Vec(0.3, 0.1, 0.3));
    EXPECT_LT((atSurface.velocity - U).norm(), 1e-14);
    EXPECT_NEAR(atSurface.pressure, 0, 1e-3 * rho0 * 9.81 * dx);
    const LiquidMean far = liquidMean(water.snapshot(), Vec(0.3, 0.1, 1));
    EXPECT_EQ(far.velocity, Vec::Zero());
    EXPECT_EQ(far.pressure, 0);
}

} // namespace
} // namespace slosh
