// SPDX-License-Identifier: GPL-3.0-or-later
// The pipeline as users run it: what it writes, restarts, threads, frames.
#include "CaseDirectory.hpp"
#include "restart.hpp"
#include "samples.hpp"

#include <gtest/gtest.h>

#include <sstream>

namespace slosh
{
namespace
{

namespace fs = std::filesystem;

class Run : public testing::Test
{
protected:
    CaseDirectory case_;
};

TEST_F(Run, WritesTimeDirectoriesAndSamplesAndNamesItsChoices)
{
    const std::string filled = case_.succeed("blockParticles");
    for (const std::string words :
         {"Liquid particles: 200", "Wall particles  : 344", "omega1 = ", "omega3 = ", "memory", "run time per second",
          "= rho0 V to "})
    {
        EXPECT_NE(filled.find(words), std::string::npos) << words << "\n" << filled;
    }
    const std::string log = case_.succeed("sloshSPHFoam -threads 1");
    for (const std::string words :
         {"pair loop: 2D, kernel improvedGaussian, viscosity artificial",
          "omitted: ", "oscillatingRotatingMotion: origin (0 0 0.1)", "Time = 0.05\n", "ExecutionTime = ", "\nEnd\n"})
    {
        EXPECT_NE(log.find(words), std::string::npos) << words << "\n" << log;
    }
    for (const std::string file :
         {"0.05/lagrangian/fluid/positions", "0.1/lagrangian/wall/U", "0.1/uniform/lagrangian/fluid/cloudProperties",
          "postProcessing/pressure/0/p", "postProcessing/gauges/0/height.dat", "postProcessing/forces/0/force.dat",
          "postProcessing/forces/0/moment.dat", "postProcessing/energies/0/energies.dat"})
    {
        EXPECT_TRUE(fs::exists(case_.path() / file)) << file;
    }
    // Sampled every 0.01 s, written every 0.05 s.
    const auto rows = rowsOf(case_.text("postProcessing/pressure/0/p"));
    ASSERT_EQ(rows.size(), 11u);
    ASSERT_EQ(rows[0].size(), 4u);
    EXPECT_EQ(rows[0][0], 0);
    EXPECT_EQ(rows[10][0], 0.1);
    EXPECT_EQ(rows[10][3], 0) << "the dry probe";
    for (const auto& item : fs::directory_iterator(case_.path()))
    {
        EXPECT_TRUE(item.path().extension() == ".foam" || item.path().filename().string().front() != '.')
            << "left over: " << item.path();
    }
}

TEST_F(Run, SaysThatFunctionsAreLeftOutWhereThereAreNone)
{
    const std::string words = "omitted: functions";
    case_.edit("system/controlDict", "endTime 0.1", "endTime 0.001");
    case_.succeed("blockParticles");
    EXPECT_NE(case_.succeed("sloshSPHFoam -noFunctionObjects").find(words), std::string::npos);
    case_.edit("system/controlDict", "endTime 0.001", "endTime 0.002");
    EXPECT_EQ(case_.succeed("sloshSPHFoam").find(words), std::string::npos);
}

TEST_F(Run, SaysAtItsEndWhereTheTimeWentAndLeavesNothingOut)
{
    case_.succeed("blockParticles");
    const std::string log = case_.succeed("sloshSPHFoam -threads 1");
    std::istringstream lines(log.substr(log.find("Wall-clock seconds")));
    std::string line;
    std::getline(lines, line);
    double shares = 0;
    int kinds = 0;
    for (; std::getline(lines, line) && line.starts_with("    "); ++kinds)
    {
        std::istringstream figures(line.substr(30));
        double s = -1, share = -1;
        figures >> s >> share;
        EXPECT_GE(s, 0) << line;
        EXPECT_GT(share, -1) << line;
        shares += share;
    }
    EXPECT_GE(kinds, 7) << log;
    EXPECT_NEAR(shares, 100, 0.05 * kinds);
    EXPECT_TRUE(line.starts_with("Total over right-hand sides: ")) << line;
}

TEST_F(Run, StartsHydrostaticWithTheExactMass)
{
    case_.remove("constant/dynamicMeshDict");
    case_.edit("system/controlDict", "endTime 0.1", "endTime 0.01");
    case_.succeed("blockParticles");
    case_.succeed("sloshSPHFoam");
    const auto p = rowsOf(case_.text("postProcessing/pressure/0/p")).front();
    EXPECT_NEAR(p[1], 1000 * 9.81 * 0.05, 0.01 * 490.5);
    EXPECT_NEAR(p[2], p[1], 1e-6 * p[1]);
    const auto height = rowsOf(case_.text("postProcessing/gauges/0/height.dat")).front();
    EXPECT_NEAR(height[1], 0.1, 0.05 * 0.01);
    const std::string state = case_.text("0/uniform/tankState");
    const double mass = std::stod(state.substr(state.find("mass ") + 5));
    EXPECT_NEAR(200 * mass, 1000 * 0.2 * 0.1, 1e-12);
}

TEST_F(Run, HasTheSameBitsAtAnyNumberOfThreads)
{
    case_.succeed("blockParticles");
    CaseDirectory two, four;
    two.copyFrom(case_);
    four.copyFrom(case_);
    case_.succeed("sloshSPHFoam -threads 1");
    two.succeed("sloshSPHFoam -threads 2");
    four.succeed("sloshSPHFoam -threads 4");
    for (const CaseDirectory* other : {&two, &four})
    {
        expectSameState(case_, *other, "0.05");
        expectSameState(case_, *other, "0.1");
        EXPECT_EQ(case_.text("postProcessing/pressure/0/p"), other->text("postProcessing/pressure/0/p"));
        EXPECT_EQ(case_.text("postProcessing/forces/0/moment.dat"), other->text("postProcessing/forces/0/moment.dat"));
        EXPECT_EQ(
            case_.text("postProcessing/energies/0/energies.dat"), other->text("postProcessing/energies/0/energies.dat")
        );
    }
}

TEST_F(Run, RestartedFromABinaryTimeContinuesBitForBit)
{
    expectRestartContinuesBitForBit(case_, "1");
}

TEST_F(Run, BeginsItsEnergyBudgetAnewWhereARestartFindsNoneAndSaysSinceWhen)
{
    case_.edit("system/controlDict", "budget yes;", "");
    case_.edit("system/controlDict", "endTime 0.1", "endTime 0.05");
    case_.succeed("blockParticles");
    EXPECT_NE(case_.succeed("sloshSPHFoam").find("omitted: the energy budget"), std::string::npos);
    EXPECT_FALSE(fs::exists(case_.path() / "0.05/uniform/energyBudget"));
    case_.edit("system/controlDict", "type energies;", "type energies; budget yes;");
    case_.edit("system/controlDict", "endTime 0.05", "endTime 0.1");
    EXPECT_EQ(case_.succeed("sloshSPHFoam").find("omitted: the energy budget"), std::string::npos);
    EXPECT_NE(
        case_.text("postProcessing/energies/0.05/energies.dat").find("Accumulated since t = 0.05 s"), std::string::npos
    );
    const Ended refused = case_.run("probeSample");
    EXPECT_EQ(refused.status, 1);
    EXPECT_NE(refused.err.find("the state at t = 0.05 s has no energy budget"), std::string::npos) << refused.err;
}

TEST_F(Run, ClosesItsEnergyBudgetToAThousandthOfTheWork)
{
    case_.succeed("blockParticles");
    case_.succeed("sloshSPHFoam");
    const auto rows = rowsOf(case_.text("postProcessing/energies/0/energies.dat"));
    ASSERT_EQ(rows.front().size(), 13u);
    const double work = rows.back()[6];
    EXPECT_GT(work, 0);
    EXPECT_GT(rows.back()[7], 0.001 * work) << "viscosity takes nothing";
    for (const auto& row : rows)
    {
        EXPECT_NEAR(row[12] / work, 0, 1e-3);
    }
}

TEST_F(Run, RestartedWithPositionVerletContinuesBitForBit)
{
    case_.write(
        "system/sphSchemes",
        case_.text("system/sphSchemes") + "timeIntegration positionVerlet;\ndensityDiffusion { type Fourtakas; }\n"
    );
    expectRestartContinuesBitForBit(case_, "4");
}

TEST_F(Run, RestartedInTheInertialFrameContinuesBitForBit)
{
    case_.edit("system/sphSchemes", "frame tank", "frame inertial");
    expectRestartContinuesBitForBit(case_, "4");
}

TEST_F(Run, RestartedWithAMotionTableContinuesBitForBit)
{
    case_.write(
        "constant/dynamicMeshDict", "solidBodyMotionFunction tabulated6DoFMotion;\n"
                                    "tabulated6DoFMotionCoeffs { CofG (0 0 0); timeDataFileName "
                                    "\"constant/6DoF.dat\"; }\n"
    );
    case_.write(
        "constant/6DoF.dat", "4\n(\n(0 ((0 0 0) (0 0 0)))\n(0.03 ((0 0.001 0) (1 0 0)))\n(0.07 ((0 0.002 0) (3 0 0)))\n"
                             "(0.12 ((0 0 0) (2 0 0)))\n)\n"
    );
    expectRestartContinuesBitForBit(case_, "2");
}

TEST_F(Run, RestartedFromAsciiContinuesToTheDigitsWritten)
{
    case_.edit("system/controlDict", "writeFormat binary", "writeFormat ascii");
    case_.succeed("blockParticles");
    CaseDirectory stopped;
    stopped.copyFrom(case_);
    case_.succeed("sloshSPHFoam");
    stopped.edit("system/controlDict", "endTime 0.1", "endTime 0.05");
    stopped.succeed("sloshSPHFoam");
    stopped.edit("system/controlDict", "endTime 0.05", "endTime 0.1");
    stopped.succeed("sloshSPHFoam");
    const auto whole = rowsOf(case_.text("postProcessing/pressure/0/p"));
    const auto after = rowsOf(stopped.text("postProcessing/pressure/0.05/p"));
    ASSERT_EQ(after.size(), 5u);
    for (std::size_t i = 0; i < after.size(); ++i)
    {
        EXPECT_NEAR(after[i][1], whole[i + 6][1], 1e-3 * 490.5);
    }
}

TEST_F(Run, InTheTanksFrameAndInTheInertialOneGivesTheSamePressures)
{
    // Equal steps: adjusted ones depend on the frame's speeds, and with them the instants of moving least squares.
    case_.edit("system/controlDict", "adjustTimeStep yes", "adjustTimeStep no");
    case_.edit("system/controlDict", "deltaT 1e-4", "deltaT 2e-4");
    case_.succeed("blockParticles");
    CaseDirectory inertial;
    inertial.copyFrom(case_);
    inertial.edit("system/sphSchemes", "frame tank", "frame inertial");
    case_.succeed("sloshSPHFoam");
    inertial.succeed("sloshSPHFoam");
    const auto a = rowsOf(case_.text("postProcessing/pressure/0/p"));
    const auto b = rowsOf(inertial.text("postProcessing/pressure/0/p"));
    ASSERT_EQ(a.size(), b.size());
    double peak = 0, difference = 0, change = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
    {
        for (const std::size_t probe : {1u, 2u})
        {
            peak = std::max(peak, std::abs(a[i][probe]));
            difference = std::max(difference, std::abs(a[i][probe] - b[i][probe]));
            change = std::max(change, std::abs(a[i][probe] - a[0][probe]));
        }
    }
    EXPECT_LT(difference, 0.01 * peak);
    EXPECT_GT(change, 0.1 * peak) << "the motion is felt";
}

TEST_F(Run, PurgeWriteKeepsTheLatestTimesAndTheStart)
{
    case_.edit("system/controlDict", "writeInterval 0.05;", "writeInterval 0.02; purgeWrite 2;");
    case_.succeed("blockParticles");
    case_.succeed("sloshSPHFoam");
    for (const auto& [time, kept] :
         {std::pair("0", true), {"0.02", false}, {"0.04", false}, {"0.06", false}, {"0.08", true}, {"0.1", true}})
    {
        EXPECT_EQ(fs::exists(case_.path() / time), kept) << time;
    }
}

TEST_F(Run, NoFunctionObjectsLeavesThemOut)
{
    case_.succeed("blockParticles");
    const std::string log = case_.succeed("sloshSPHFoam -noFunctionObjects");
    EXPECT_NE(log.find("Functions: none"), std::string::npos);
    EXPECT_FALSE(fs::exists(case_.path() / "postProcessing"));
    EXPECT_TRUE(fs::exists(case_.path() / "0.1"));
}

TEST_F(Run, DryRunReadsAllAndWritesNothing)
{
    case_.succeed("blockParticles");
    const auto untouched = case_.tree();
    EXPECT_NE(case_.succeed("sloshSPHFoam -dry-run").find("Dry run: the case can be run"), std::string::npos);
    EXPECT_EQ(case_.tree(), untouched);
    case_.write("constant/kernelProperties", "kernel gausian;\n");
    EXPECT_EQ(case_.run("sloshSPHFoam -dry-run").status, 1);
}

TEST_F(Run, AtConstantTimeStepTakesTheStepsAskedFor)
{
    case_.edit("system/controlDict", "adjustTimeStep yes", "adjustTimeStep no");
    case_.edit("system/controlDict", "deltaT 1e-4", "deltaT 2e-4");
    case_.edit(
        "system/controlDict", "writeControl adjustableRunTime;\nwriteInterval 0.05",
        "writeControl timeStep;\nwriteInterval 250"
    );
    case_.succeed("blockParticles");
    EXPECT_NE(case_.succeed("sloshSPHFoam").find("Steps: 500,"), std::string::npos);
    EXPECT_TRUE(fs::exists(case_.path() / "0.05"));
}

TEST_F(Run, EntryThatIsSetButNotNeededIsNamed)
{
    case_.edit("constant/fluidProperties", "type artificial", "type none");
    EXPECT_NE(case_.succeed("blockParticles").find("Not used: constant/fluidProperties:3: alpha"), std::string::npos);
    case_.edit("system/controlDict", "adjustTimeStep yes", "adjustTimeStep no; maxCo 0.2");
    EXPECT_NE(case_.succeed("sloshSPHFoam").find("Not used: system/controlDict:6: maxCo"), std::string::npos);
}

TEST_F(Run, StopAtWriteNowWritesAfterOneStep)
{
    case_.edit("system/controlDict", "startFrom latestTime;", "startFrom latestTime; stopAt writeNow;");
    case_.succeed("blockParticles");
    EXPECT_NE(case_.succeed("sloshSPHFoam").find("Steps: 1,"), std::string::npos);
}

class Baffled : public Run
{
protected:
    void SetUp() override
    {
        case_.edit("constant/tankProperties", "fillDepth 0.1;", R"(fillDepth 0.1;
geometry { baffle { type searchableBox; min (-0.5 -0.02 0); max (0.5 0.02 0.05); } })");
    }
};

TEST_F(Baffled, TankHoldsTheLiquidBesideTheBaffleAlone)
{
    const std::string log = case_.succeed("blockParticles");
    // 20 x 10 cells less 4 x 5 of the baffle.
    EXPECT_NE(log.find("Liquid particles: 180"), std::string::npos) << log;
    case_.succeed("sloshSPHFoam");
}

TEST(ThreeDimensions, RunFromTheSameDictionaries)
{
    const CaseDirectory theCase;
    theCase.edit(
        "constant/tankProperties", "plane yz;\nmin (-0.5 -0.1 0);\nmax (0.5 0.1 0.15)",
        "min (-0.05 -0.1 0);\nmax (0.05 0.1 0.15)"
    );
    theCase.edit("system/blockParticlesDict", "0.01", "0.0125");
    theCase.edit("system/controlDict", "endTime 0.1", "endTime 0.02");
    EXPECT_NE(theCase.succeed("blockParticles").find("Liquid particles: 1024"), std::string::npos);
    EXPECT_NE(theCase.succeed("sloshSPHFoam").find("pair loop: 3D"), std::string::npos);
    const auto rows = rowsOf(theCase.text("postProcessing/pressure/0/p"));
    EXPECT_NEAR(rows[0][1], 1000 * 9.81 * 0.05, 0.2 * 490.5);
}

} // namespace
} // namespace slosh
