// SPDX-License-Identifier: GPL-3.0-or-later
// Samples of still water on a lattice, where every answer is known.
#include "StillWater.hpp"

#include "physics/loadByMomentum.hpp"
#include "sampling/SampleFile.hpp"
#include "sampling/liquidState.hpp"
#include "sampling/loadsOnParts.hpp"
#include "sampling/samplePoint.hpp"
#include "viscosities/readViscosity.hpp"

#include "particles/changeFrame.hpp"
#include "particles/liquidEnergies.hpp"
#include "physics/makeInteractions.hpp"

#include <gtest/gtest.h>

#include <numeric>

#include <fstream>
#include <sstream>
#include <unistd.h>

namespace slosh
{
namespace
{

namespace fs = std::filesystem;

TEST(PressureProbe, ReadsTheHydrostaticValueAtAWallWithEveryKernelIn2DAnd3D)
{
    for (const int dim : {2, 3})
    {
        for (const std::string& kernel : Kernel::names())
        {
            const StillWater water(dim, kernel);
            const Snapshot snapshot = water.snapshot();
            for (const Vec& X : {Vec(0, 0.1, 0.15), Vec(0.6, 0.1, 0.0731), Vec(0.3, 0.1, 0), Vec(0.217, 0.1, 0.2)})
            {
                EXPECT_NEAR(pressureAt(snapshot, X), rho0 * g * (D - X.z()), 2e-4 * rho0 * g * D)
                    << kernel << ' ' << dim << "D at " << X.transpose();
            }
        }
    }
}

TEST(PressureProbe, ReadsNothingWhereItIsDry)
{
    const StillWater water(2);
    const Snapshot snapshot = water.snapshot();
    EXPECT_EQ(pressureAt(snapshot, Vec(0, 0.1, 0.32)), 0);
    EXPECT_EQ(pressureAt(snapshot, Vec(0.3, 0.1, 0.5)), 0);
    EXPECT_GT(pressureAt(snapshot, Vec(0, 0.1, 0.28)), 0);
}

TEST(PressureProbe, FeelsNoSuctionAtAWallThatDoesNotPull)
{
    StillWater water(2);
    for (auto& p : water.particles.p)
    {
        p -= rho0 * g * D; // tension, from 0 at the bottom to -rho g D at the surface
    }
    const double dx = water.dx, pull = -rho0 * g * 0.15;
    const auto read = [&](double x) { return pressureAt(water.snapshot(), Vec(x, 0.1, 0.15)); };
    EXPECT_EQ(read(0), 0);
    EXPECT_EQ(read(0.6 - 0.49 * dx), 0);
    EXPECT_NEAR(read(0.51 * dx), pull, 2e-4 * rho0 * g * D);
    EXPECT_NEAR(read(0.3), pull, 2e-4 * rho0 * g * D);
    water.scene.wallSuction = true;
    EXPECT_NEAR(read(0), pull, 2e-4 * rho0 * g * D);
}

TEST(WaveGauge, FindsTheStillLevelToATwentiethOfTheSpacing)
{
    for (const int dim : {2, 3})
    {
        for (const std::string& kernel : Kernel::names())
        {
            const StillWater water(dim, kernel);
            const Snapshot snapshot = water.snapshot();
            for (const double x : {0.0, 0.003, 0.04, 0.3137, 0.6})
            {
                EXPECT_NEAR(surfaceLevel(snapshot, Vec(x, 0.1, 0)), D, 0.05 * water.dx) << kernel << ' ' << dim << "D";
            }
        }
    }
}

TEST(WaveGauge, ReadsTheVolumeBelowAndNotThePlaceOfTheOutermostParticles)
{
    for (const std::string& kernel : Kernel::names())
    {
        StillWater water(2, kernel);
        for (int i = 0; i < water.particles.nFluid; ++i)
        {
            Vec& r = water.particles.r[i];
            if (r.z() > D - water.dx)
            {
                r.z() += 0.3 * water.dx; // the same volume, less densely
            }
        }
        EXPECT_NEAR(surfaceLevel(water.snapshot(), Vec(0.3137, 0.1, 0)), D, 0.05 * water.dx) << kernel;
    }
}

TEST(WaveGauge, ReadsTheTopOfADropAboveTheLiquid)
{
    StillWater water(2);
    const double dx = water.dx;
    const double height = 0.05; // of the drop's middle above the surface
    for (int i = 0; i < water.particles.nFluid; ++i)
    {
        Vec& r = water.particles.r[i];
        if (std::abs(r.x() - 0.3) < 3 * dx && r.z() > D - 6 * dx)
        {
            r.z() += height + 3 * dx; // six by six particles, from a hollow as large
        }
    }
    EXPECT_NEAR(surfaceLevel(water.snapshot(), Vec(0.3, 0.1, 0)), D + height + 3 * dx, 0.3 * dx);
}

/// Of all parts.
Load loadOnTank(const Snapshot& snapshot, const Vec& CofR)
{
    const std::vector<Load> parts = loadsOnParts(snapshot, CofR, true);
    return std::accumulate(parts.begin(), parts.end(), Load());
}

TEST(Samples, AreTheSameInEitherFrame)
{
    StillWater water(3);
    water.state.tank.c = Vec(0.1, 0.2, -0.3);
    water.state.tank.R = Eigen::AngleAxisd(0.2, Vec(1, 2, 3).normalized()).toRotationMatrix();
    water.state.tank.omega = Vec(0.3, 1, -0.5);
    water.state.tank.omegaDot = Vec(3, 1, -2);
    const Snapshot inTank = water.snapshot();
    StillWater other(3);
    other.state = water.state;
    changeFrame(other.particles, other.state.solverFrame(), Frame::inertial);
    other.state.frame = Frame::inertial;
    const Snapshot inertial = other.snapshot();
    const Vec X(0, 0.1, 0.15);
    EXPECT_NEAR(pressureAt(inTank, X), pressureAt(inertial, X), 1e-8);
    EXPECT_NEAR(surfaceLevel(inTank, X), surfaceLevel(inertial, X), 1e-12);
    const LiquidState a = liquidState(inTank), b = liquidState(inertial);
    EXPECT_NEAR((a.centreInTank - b.centreInTank).norm(), 0, 1e-13);
    const Load p = loadOnTank(inTank, Vec(0.3, 0.1, 0)), q = loadOnTank(inertial, Vec(0.3, 0.1, 0));
    const Wrench inTankFrame = p.total(), inInertialFrame = q.total();
    EXPECT_NEAR((inTankFrame.force - inInertialFrame.force).norm(), 0, 1e-8 * inTankFrame.force.norm());
    EXPECT_NEAR((inTankFrame.moment - inInertialFrame.moment).norm(), 0, 1e-8 * inTankFrame.force.norm());
}

TEST(LiquidEnergies, AreThoseOfABodyInEitherFrame)
{
    StillWater water(2);
    const double mass = rho0 * 0.6 * 0.2 * D; // 0.2 m thick
    const auto energies = [&]
    {
        return liquidEnergies(
            water.particles, water.scene.equationOfState, water.scene.gravity, water.state.solverFrame(),
            water.scene.tank.thickness()
        );
    };
    EXPECT_EQ(energies().kinetic, 0);
    EXPECT_NEAR(energies().potential, mass * g * D / 2, 1e-4 * mass * g * D);
    // Compressed by p: m p^2/(2 rho^2 c^2) while p is small; the mean square of the pressure is (rho g D)^2/3.
    EXPECT_NEAR(energies().internal / (mass * g * g * D * D / 6 / 9e4), 1, 0.01);
    for (std::ptrdiff_t i = 0; i < water.particles.nFluid; ++i)
    {
        water.particles.v[i] = Vec(3, 0, 4);
    }
    water.state.tank.velocity = Vec(0, 0, -4);
    water.state.tank.c = Vec(0, 0, 2);
    const LiquidEnergies inTank = energies();
    EXPECT_NEAR(inTank.kineticInTank, mass * 12.5, 1e-9 * mass);
    EXPECT_NEAR(inTank.kinetic, mass * 4.5, 1e-9 * mass);
    EXPECT_NEAR(inTank.potential, mass * g * (2 + D / 2), 1e-4 * mass * g * D);
    changeFrame(water.particles, water.state.solverFrame(), Frame::inertial);
    water.state.frame = Frame::inertial;
    EXPECT_NEAR(energies().kineticInTank, inTank.kineticInTank, 1e-9 * mass);
    EXPECT_NEAR(energies().kinetic, inTank.kinetic, 1e-9 * mass);
    EXPECT_NEAR(energies().total(), inTank.total(), 1e-9 * mass);
}

TEST(LiquidState, HasTheCentreOfAStillBody)
{
    StillWater water(2);
    const LiquidState rest = liquidState(water.snapshot());
    EXPECT_NEAR((rest.centreInTank - Vec(0.3, 0.1, D / 2)).norm(), 0, 1e-4 * D);
    for (std::ptrdiff_t i = 0; i < water.particles.nFluid; ++i)
    {
        water.particles.v[i] = Vec(3, 0, 4);
    }
    const LiquidState moving = liquidState(water.snapshot());
    EXPECT_NEAR((moving.velocity - Vec(3, 0, 4)).norm(), 0, 1e-12);
}

TEST(LiquidState, ReachesFromBottomToSurfaceAndHasTheSecondMomentsOfTheBox)
{
    for (const int dim : {2, 3})
    {
        const StillWater water(dim);
        const LiquidState liquid = liquidState(water.snapshot());
        EXPECT_NEAR(liquid.extent.min().x(), 0, 1e-9);
        EXPECT_NEAR(liquid.extent.max().x(), 0.6, 1e-9);
        EXPECT_NEAR(liquid.extent.max().z(), D, 1e-4);
        // Of n points on a line of length L the variance is L^2/12 (1 - 1/n^2).
        EXPECT_NEAR(liquid.semiAxes.x(), 0.6 * std::sqrt((dim + 2) / 12.0 * (1 - 1.0 / 900)), 1e-9);
        EXPECT_NEAR(liquid.semiAxes.y(), dim == 2 ? 0 : 0.2 * std::sqrt(5 / 12.0 * (1 - 1.0 / 100)), 1e-9);
    }
}

TEST(LoadOnTank, IsTheWeightOfTheWaterAtRest)
{
    for (const int dim : {2, 3})
    {
        const StillWater water(dim);
        const double weight = rho0 * 0.6 * 0.2 * D * g;
        const Wrench load = loadOnTank(water.snapshot(), Vec(0.3, 0.1, 0)).total();
        EXPECT_NEAR(load.force.z(), -weight, 0.01 * weight) << dim << "D";
        EXPECT_NEAR(load.force.x(), 0, 1e-10 * weight) << dim << "D";
        EXPECT_NEAR(load.moment.norm(), 0, 1e-10 * weight) << dim << "D";
    }
}

/// From the accelerations of the same particles, as physics/ sums them.
Wrench loadByAccelerations(StillWater& water)
{
    Particles& particles = water.particles;
    const Scene& scene = water.scene;
    const double h = scene.kernel.smoothingLength();
    const auto& directions = scene.tank.directions();
    const int dim = scene.tank.dim();
    const auto pairs = makeInteractions(
        {dim, {directions[0], directions[1], dim == 2 ? 0 : directions.back()}, h}, scene.kernel.choice(),
        {scene.viscosity, {}, scene.fluid.slip}, Precision::reference
    );
    ClusterLists list;
    list.build(particles, directions, scene.kernel.supportRadius());
    pairs->listBuilt(particles, list, scene.kernel.supportRadius());
    std::vector<WallContact> contact;
    pairs->see(list, {water.snapshot().bodyForce(), scene.equationOfState, false}, nullptr, particles, contact);
    Rates rates;
    rates.resize(particles.nFluid);
    pairs->rates(Wanted::acceleration, list, particles, water.snapshot().bodyForce(), rates);
    return loadByMomentum(particles, rates.acceleration, water.snapshot().frame(), scene.gravity, scene.tank);
}

TEST(LoadOnTank, OfABodyIsItsBuoyancy)
{
    for (const int dim : {2, 3})
    {
        StillWater water(
            dim, "improvedGaussian",
            "block { type searchableBox; min (0.2 -1 0.1); max (0.4 1 0.2); } "
            "sill { type searchableBox; min (0.5 -1 -1); max (1 1 0.06); }"
        );
        const Vec CofR(0.3, 0.1, 0);
        const std::vector<Load> parts = loadsOnParts(water.snapshot(), CofR, true);
        EXPECT_EQ(water.scene.tank.partNames(), (std::vector<std::string>{"walls", "block", "sill"}));
        ASSERT_EQ(parts.size(), 3);
        const double weight = rho0 * 0.2 * g; // of a square metre of water, 0.2 m thick
        // Where a body ends at a wall, that one bears a share of it.
        EXPECT_NEAR(parts[1].total().force.z() / (weight * 0.02), 1, dim == 2 ? 0.002 : 0.07) << dim << "D";
        EXPECT_NEAR(parts[1].total().force.x(), 0, 1e-3 * weight) << dim << "D";
        // Water on its top alone.
        EXPECT_NEAR(parts[2].total().force.z() / (-weight * 0.1 * 0.24), 1, dim == 2 ? 0.07 : 0.13) << dim << "D";
        const Wrench byMomentum = loadByAccelerations(water);
        const Wrench whole = loadOnTank(water.snapshot(), Vec::Zero()).total();
        EXPECT_LT((whole.force - byMomentum.force).norm(), 1e-10 * whole.force.norm()) << dim << "D";
        EXPECT_LT((whole.moment - byMomentum.moment).norm(), 1e-10 * whole.force.norm()) << dim << "D";
    }
}

TEST(LongLoadOnTank, IsTheReactionToWhatTheWallsDoToTheLiquidWithEveryViscosity)
{
    // Of sound; in the gentle one walls beside the surface have a pressure below 0 that repels all the same.
    for (const auto& [dim, sound] : {std::pair(2, 1e-3), std::pair(3, 1e-3), std::pair(2, 1e-5), std::pair(3, 1e-5)})
    {
        const TaitEquation state = StillWater(dim).scene.equationOfState;
        const ViscosityChoice artificial = ArtificialViscosity::of(state, 0.03), laminar = LaminarViscosity{0.1},
                              riemann = LowDissipationRiemann::of(state);
        for (const auto& [viscosity, slip] :
             {std::pair(ViscosityChoice(), false), std::pair(artificial, false), std::pair(artificial, true),
              std::pair(laminar, false), std::pair(laminar, true), std::pair(riemann, false), std::pair(riemann, true)})
        {
            StillWater water(dim);
            water.scene.viscosity = viscosity;
            water.scene.fluid.slip = slip;
            for (std::ptrdiff_t i = 0; i < water.particles.nFluid; ++i)
            {
                const Vec& r = water.particles.r[i];
                water.particles.v[i] = Vec(3 * std::sin(40 * r.x() + 1), 0, 2 * std::cos(30 * r.z() - 9 * r.x()));
                water.particles.rho[i] *= 1 + sound * std::sin(50 * r.x()) * std::cos(20 * r.z());
                water.particles.p[i] = water.scene.equationOfState.p(water.particles.rho[i]);
            }
            const Wrench byMomentum = loadByAccelerations(water);
            const Load load = loadOnTank(water.snapshot(), Vec::Zero());
            const double size = load.pressure.force.norm();
            EXPECT_LT((load.total().force - byMomentum.force).norm(), 1e-10 * size) << dim << "D, " << sound;
            EXPECT_LT((load.total().moment - byMomentum.moment).norm(), 1e-10 * size) << dim << "D, " << sound;
            if (isNone(viscosity) || slip)
            {
                EXPECT_EQ(load.viscous.force, Vec(Vec::Zero()));
            }
            else
            {
                EXPECT_GT(load.viscous.force.norm(), 1e-3 * size) << dim << "D, " << sound;
            }
        }
    }
}

TEST(SampleFile, EndsColumnsWhereOpenFOAMDoes)
{
    const fs::path file = fs::temp_directory_path() / ("slosh.samples." + std::to_string(::getpid())) / "0/p";
    SampleFile samples(file, "# Probe 0\n", 6);
    EXPECT_FALSE(fs::exists(file)) << "before the first row";
    samples.beginRow(0.00119048);
    samples.add(875.238);
    samples.add(1.28877);
    samples.endRow();
    samples.beginRow(2);
    samples.add(Vec(1, 0.5, -2));
    samples.endRow();
    std::ifstream in(file);
    std::stringstream text;
    text << in.rdbuf();
    // OpenFOAM's own.
    EXPECT_EQ(
        text.str(), "# Probe 0\n   0.00119048       875.238       1.28877\n            2             (1 0.5 -2)\n"
    );
    fs::remove_all(file.parent_path().parent_path());
}

} // namespace
} // namespace slosh
