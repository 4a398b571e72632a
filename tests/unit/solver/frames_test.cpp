// SPDX-License-Identifier: GPL-3.0-or-later
// The tank's frame and the inertial one, held against each other.
#include "Sloshing.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace slosh
{
namespace
{

/// Largest distance between a particle's place in the tank after 20 ms in one frame and in the other, [m].
double differenceOfFrames(const Sloshing& scene, Schemes schemes, long steps)
{
    constexpr double end = 0.02;
    schemes.precision = Precision::doublePrecision;
    schemes.densityInterval = 0;
    WeaklyCompressible inTank = scene.solver(schemes);
    schemes.frame = Frame::inertial;
    WeaklyCompressible inertial = scene.solver(schemes);
    advance(inTank, steps, end / static_cast<double>(steps));
    advance(inertial, steps, end / static_cast<double>(steps));
    const RigidState tank = scene.scene.motion->at(end);
    std::map<int, Vec> X; // lists sort the particles
    for (std::size_t i = 0; i < static_cast<std::size_t>(inertial.particles().nFluid); ++i)
    {
        X[inertial.particles().id[i]] = tank.pointToTank(inertial.particles().r[i]);
    }
    double difference = 0;
    for (std::size_t i = 0; i < static_cast<std::size_t>(inTank.particles().nFluid); ++i)
    {
        difference = std::max(difference, (inTank.particles().r[i] - X[inTank.particles().id[i]]).norm());
    }
    EXPECT_GT(inTank.maxSpeed(), 0.005) << "nothing sloshes";
    return difference;
}

TEST(LongFrames, MovesTheLiquidAlikeInBothFramesToSecondOrderInTheStep)
{
    for (const std::string& integrator : TimeIntegrator::names())
    {
        for (const int dim : {2, 3})
        {
            Sloshing scene(dim, "wendlandC2"); // smooth at its end, where pairs of a lattice may stand
            Schemes schemes;
            schemes.timeIntegration = integrator;
            schemes.densityDiffusion = integrator == "positionVerlet" ? 0.1 : 0;
            scene.scene.wallSuction = true; // smooth in time: a wall that lets go of the liquid does so at once
            const double coarse = differenceOfFrames(scene, schemes, 100);
            const double fine = differenceOfFrames(scene, schemes, 200);
            EXPECT_LT(coarse, 1e-4 * 0.01) << dim << "D: a ten-thousandth of the spacing";
            EXPECT_NEAR(std::log2(coarse / fine), 2, 0.3) << dim << "D, " << integrator;
        }
    }
}

TEST(Frames, MovesTheLiquidAlikeInBothFramesWithWallsThatDoNotPull)
{
    for (const std::string& integrator : TimeIntegrator::names())
    {
        for (const int dim : {2, 3})
        {
            Schemes schemes;
            schemes.timeIntegration = integrator;
            EXPECT_LT(differenceOfFrames(Sloshing(dim, "wendlandC2"), schemes, 100), 1e-4 * 0.01)
                << dim << "D, " << integrator << ": a ten-thousandth of the spacing";
        }
    }
}

TEST(Frames, HasTheSameFrictionAndDampingInBothFrames)
{
    Sloshing scene(2, "wendlandC2");
    Schemes schemes;
    schemes.timeIntegration = "positionVerlet";
    scene.scene.fluid.slip = true;
    scene.scene.fluid.friction.boundaryLayers = true;
    scene.scene.fluid.friction.nu = 1e-3;
    schemes.soundDamping = 1;
    const double difference = differenceOfFrames(scene, schemes, 200);
    EXPECT_LT(difference, 1e-5 * 0.01) << "a hundred-thousandth of the spacing";
}

} // namespace
} // namespace slosh
