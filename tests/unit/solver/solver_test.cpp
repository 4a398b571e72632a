// SPDX-License-Identifier: GPL-3.0-or-later
// The stages of the scheme on a small tank that moves.
#include "Sloshing.hpp"
#include "physics/FourtakasDensityDiffusion.hpp"
#include "physics/WallFriction.hpp"

#include "base/CaseError.hpp"
#include "case/namedSchemes.hpp"
#include "dictionary/Dictionary.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace slosh
{
namespace
{

/// Off the lattice, where no distance is the support radius itself: the Gaussian's gradient ends there with a jump.
void disturb(Particles& particles)
{
    for (std::ptrdiff_t i = 0; i < particles.nFluid; ++i)
    {
        const double s = static_cast<double>(particles.id[i]);
        particles.r[i] += 1e-3 * Vec(std::sin(7 * s), 0, std::sin(11 * s));
        particles.rho[i] *= 1 + 0.005 * std::sin(13 * s);
    }
}

/// Largest difference of the accelerations, over the largest acceleration that pairs give.
double differenceOfRates(const Rates& a, const Rates& b)
{
    double difference = 0, scale = 0;
    for (std::size_t i = 0; i < a.acceleration.size(); ++i)
    {
        difference = std::max(difference, (a.acceleration[i] - b.acceleration[i]).norm());
        scale = std::max(scale, a.acceleration[i].norm());
    }
    return difference / scale;
}

TEST(WeaklyCompressible, HasTheRatesOfTheReferenceInEveryPrecision)
{
    for (const int dim : {2, 3})
    {
        const Sloshing scene(dim);
        Schemes schemes;
        const auto rates = [&](Precision precision)
        {
            schemes.precision = precision;
            WeaklyCompressible solver = scene.solver(schemes, disturb);
            solver.updateNeighbours(1e-4);
            solver.beginStep();
            return solver.rates();
        };
        const Rates reference = rates(Precision::reference);
        EXPECT_LT(differenceOfRates(reference, rates(Precision::single)), 2e-5) << dim << "D";
        EXPECT_LT(differenceOfRates(reference, rates(Precision::doublePrecision)), 1e-12) << dim << "D";
    }
}

TEST(WeaklyCompressible, FindsTheRatesOfTheStateThatAStopAtAWallHasLeft)
{
    const Sloshing scene(2, "wendlandC2");
    Schemes schemes;
    schemes.precision = Precision::doublePrecision;
    schemes.timeIntegration = "positionVerlet";
    constexpr double dt = 2e-4;
    WeaklyCompressible solver = scene.solver(
        schemes,
        [](Particles& particles)
        {
            particles.r[5].z() = 0.001; // 1.2 mm a step
            particles.v[5].z() = -6;
        }
    );
    advance(solver, 1, dt);
    ASSERT_EQ(solver.stoppedAtWalls(), 1);
    TimeState now;
    now.time = dt;
    now.tank = scene.scene.motion->at(dt);
    Particles copy = solver.particles();
    const std::vector<Vec> walls(copy.r.begin() + copy.nFluid, copy.r.end());
    WeaklyCompressible restarted(scene.scene, schemes, std::move(copy), now, walls);
    std::map<int, double> expected;
    restarted.updateNeighbours(dt);
    restarted.beginStep();
    solver.beginStep();
    for (std::size_t i = 0; i < restarted.rates().densityRate.size(); ++i)
    {
        expected[restarted.particles().id[i]] = restarted.rates().densityRate[i];
    }
    for (std::size_t i = 0; i < solver.rates().densityRate.size(); ++i)
    {
        EXPECT_NEAR(solver.rates().densityRate[i], expected[solver.particles().id[i]], 1e-8) << i;
    }
}

TEST(WeaklyCompressible, GivesSamplesItsStateWithoutWhatRestartsAloneNeed)
{
    Sloshing scene(2, "wendlandC2");
    Schemes schemes;
    scene.scene.fluid.slip = true;
    scene.scene.fluid.friction.boundaryLayers = true;
    scene.scene.fluid.friction.nu = 1e-3;
    schemes.soundDamping = 1;
    WeaklyCompressible solver = scene.solver(schemes);
    advance(solver, 3);
    const TimeState whole = solver.state(6e-4, 3, 2e-4);
    EXPECT_FALSE(whole.sound.empty());
    for (const Field& field : WallFriction::layerFields())
    {
        EXPECT_EQ(solver.particles().values<Vec>(field.name).size(), solver.particles().nWall) << field.name;
    }
    const TimeState sample = solver.sampledState(6e-4, 3, 2e-4);
    EXPECT_TRUE(sample.sound.empty());
    EXPECT_EQ(sample.time, whole.time);
    EXPECT_EQ(sample.tank.R, whole.tank.R);
}

TEST(WeaklyCompressible, GoesBackToTheLastGoodStateWhereTheNewOneIsUnsound)
{
    const Sloshing scene(2);
    WeaklyCompressible solver = scene.solver(Schemes{});
    advance(solver, 3);
    solver.updateNeighbours(1);
    const Particles good = solver.particles();
    solver.beginStep();
    EXPECT_THROW(solver.step(6e-4, 1), UnphysicalRun); // a step of one second
    for (std::ptrdiff_t i = 0; i < good.nFluid; ++i)
    {
        EXPECT_EQ(solver.particles().rho[i], good.rho[i]);
        EXPECT_EQ(solver.particles().r[i], good.r[i]);
        EXPECT_EQ(solver.particles().v[i], good.v[i]);
    }
}

TEST(WeaklyCompressible, KeepsTheDensityOfAParticleThatHasLeftTheLiquid)
{
    const Sloshing scene(2);
    Schemes schemes;
    schemes.densityDiffusion = 0.1;
    const auto leave = [](Particles& p)
    {
        p.r[5] = Vec(0.1, 0.05, 0.15); // out of reach of liquid and roof
        p.remember({FourtakasDensityDiffusion::mean()});
        p.values<double>(FourtakasDensityDiffusion::meanField)[5] =
            -1000; // of the place it comes from, [kg/m^3/s]: 20 kg/m^3 in this run
    };
    WeaklyCompressible solver = scene.solver(schemes, leave);
    const int id = solver.particles().id[5];
    const double before = solver.particles().rho[5];
    advance(solver, 100);
    const auto& ids = solver.particles().id;
    const auto now = static_cast<std::size_t>(std::find(ids.begin(), ids.end(), id) - ids.begin());
    EXPECT_GT((solver.particles().r[now] - Vec(0.1, 0.05, 0)).norm(), 0.14);
    EXPECT_NEAR(solver.particles().rho[now], before, 1000 * 2 * 2e-4);
}

TEST(WeaklyCompressible, ReportsANumberThatIsNone)
{
    const Sloshing scene(2);
    WeaklyCompressible solver = scene.solver(Schemes{}, [](Particles& p) { p.v[5].x() = std::nan(""); });
    solver.updateNeighbours(1e-4);
    solver.beginStep();
    EXPECT_THROW(solver.step(0, 1e-4), UnphysicalRun);
}

TEST(WeaklyCompressible, RebuildsListsOnlyWhereTheLiquidHasMoved)
{
    const Sloshing scene(2);
    WeaklyCompressible solver = scene.solver(Schemes{});
    advance(solver, 100);
    EXPECT_LT(solver.rebuilds(), 50);
    const long before = solver.rebuilds();
    solver.startAfresh();
    solver.updateNeighbours(1e-4);
    EXPECT_EQ(solver.rebuilds(), before + 1);
    solver.updateNeighbours(1e-4);
    EXPECT_EQ(solver.rebuilds(), before + 1);
}

std::string descriptionOf(const WeaklyCompressible& solver)
{
    std::string text;
    for (const std::string& line : solver.description())
    {
        text += line + "\n";
    }
    return text;
}

TEST(WeaklyCompressible, SaysOfEachFeatureThatItIsLeftOutWhereItIsAndOnlyThere)
{
    // Nothing but what must be.
    Sloshing bare(2, "wendlandC2", 0);
    const Scene atRest = bare.scene.atRest(bare.scene.gravity);
    Schemes none;
    none.densityInterval = 0;
    Particles particles = fillTank(bare.scene.tank, 0.01, 4, 1000, atRest.equationOfState, 9.81, 3.69).particles;
    const std::vector<Vec> walls(particles.r.begin() + particles.nFluid, particles.r.end());
    const std::string without = descriptionOf({atRest, none, std::move(particles), TimeState(), walls});
    EXPECT_NE(
        without.find("pair loop: 2D, kernel wendlandC2, viscosity none, density diffusion none"), std::string::npos
    ) << without;

    // All that there is, in 3D.
    Sloshing full(3);
    Schemes all;
    all.frame = Frame::inertial;
    all.densityDiffusion = 0.1;
    all.precision = Precision::doublePrecision;
    Scene rich = full.scene;
    rich.tank = Tank::read(Dictionary::parse(
        "type box; min (0 0 0); max (0.2 0.1 0.2); fillDepth 0.1; geometry { baffle { type searchableBox; min (0.08 -1 "
        "0); max (0.12 1 0.05); } }",
        "constant/tankProperties"
    ));
    Particles more = fillTank(rich.tank, 0.01, 4, 1000, rich.equationOfState, 9.81, 3.69).particles;
    const std::vector<Vec> moreWalls(more.r.begin() + more.nFluid, more.r.end());
    TimeState start;
    start.tank = full.scene.motion->at(0);
    WeaklyCompressible solver(rich, all, std::move(more), start, moreWalls);
    solver.keepEnergyBudget(start);
    const std::string with = descriptionOf(solver);

    for (const std::string feature :
         {"the empty direction", "viscosity", "density diffusion", "the tank's motion and its fictitious forces",
          "density re-initialisation", "bodies in the tank", "double precision of sums over pairs",
          "the energy budget"})
    {
        EXPECT_NE(without.find("omitted: " + feature + "\n"), std::string::npos) << feature << "\n" << without;
        EXPECT_EQ(with.find("omitted: " + feature + "\n"), std::string::npos) << feature << "\n" << with;
    }
    EXPECT_NE(with.find("omitted: wall particles out of reach of the liquid"), std::string::npos) << with;
    EXPECT_NE(
        descriptionOf(Sloshing(2).solver(Schemes())).find("omitted: moving the walls (tank frame)"), std::string::npos
    );
    EXPECT_EQ(with.find("moving the walls"), std::string::npos) << with;
}

TEST(Schemes, AreThePapersWhereTheCaseNamesThemAndRefuseTheRest)
{
    const auto read = [](const std::string& text)
    {
        Dictionary dict = Dictionary::parse("scheme cao2014; " + text, "system/sphSchemes");
        for (const SchemeEntry& entry : schemeNamedIn(dict).entries)
        {
            if (entry.file == "system/sphSchemes")
            {
                dict.setDefault(entry.path, entry.value, "scheme cao2014");
            }
        }
        return Schemes::read(dict);
    };
    const Schemes standard = read("");
    EXPECT_EQ(standard.frame, Frame::tank);
    EXPECT_EQ(standard.densityInterval, 20);
    EXPECT_EQ(standard.densityDiffusion, 0);
    EXPECT_EQ(standard.timeIntegration, "predictorCorrector");
    EXPECT_EQ(read("densityDiffusion { type Fourtakas; }").densityDiffusion, 0.1);
    for (const auto& diffusion : Schemes::densityDiffusions())
    {
        const double delta = read("densityDiffusion { type " + std::string(diffusion.name) + "; }").densityDiffusion;
        EXPECT_EQ(
            std::visit([](const auto& term) { return term.name; }, chooseDensityDiffusion(delta, {1000, 10, 7})),
            diffusion.name
        );
    }
    for (const std::string& name : TimeIntegrator::names())
    {
        EXPECT_EQ(read("timeIntegration " + name + ";").timeIntegration, name);
    }
    EXPECT_EQ(read("densityReinitialisation { type none; }").densityInterval, 0);
    EXPECT_EQ(read("densityReinitialisation { type MLS; interval 30; }").densityInterval, 30);
    EXPECT_EQ(read("frame inertial; precision reference;").precision, Precision::reference);
    for (const char* wrong :
         {"frame moving;", "densityDiffusion { type Antuono; }", "densityDiffusion { type Fourtakas; delta 0; }",
          "precision half;", "densityReinitialisation { type MLS; interval 0; }", "walls { }",
          "limits { densityDeviation 1.5; }", "timeIntegration euler;"})
    {
        EXPECT_THROW(read(wrong), CaseError) << wrong;
    }
}

TEST(StableTimeStep, OfAStiffViscosityIsTheViscousOne)
{
    // With all pairs nu = alpha h c0/8 in 2D: 0.125 h^2/nu = h/(alpha c0), below 0.25 h/c0 from alpha = 4 on.
    const double acoustic = 0.25 * 0.0123 / 12;
    for (const double alpha : {1.0, 10.0, 100.0})
    {
        const Sloshing scene(2, "improvedGaussian", alpha);
        WeaklyCompressible solver = scene.solver(Schemes());
        solver.updateNeighbours(0);
        solver.beginStep();
        const double dt = solver.stableTimeStep(0.25);
        if (alpha < 4)
        {
            EXPECT_GT(dt, 0.9 * acoustic);
        }
        else
        {
            EXPECT_NEAR(dt, 0.0123 / (alpha * 12), 1e-12);
        }
    }
}

} // namespace
} // namespace slosh
