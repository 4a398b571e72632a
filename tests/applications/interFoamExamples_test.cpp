// SPDX-License-Identifier: GPL-3.0-or-later
// foamToSlosh on the interFoam cases of Debian's package openfoam-examples.
#include "installed.hpp"
#include "interFoamCase.hpp"

#include "dictionary/Dictionary.hpp"
#include "motion/SolidBodyMotion.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <regex>

namespace slosh
{
namespace
{

namespace fs = std::filesystem;

struct Example
{
    std::string name, tank;
    int dim;
};

void PrintTo(const Example& example, std::ostream* out)
{
    *out << example.name;
}

class InterFoamExample : public testing::TestWithParam<Example>
{
protected:
    void SetUp() override
    {
        if (const std::string missing = missingForInterFoamCases(); !missing.empty())
        {
            GTEST_SKIP() << missing;
        }
    }
};

/// The tank's volume as OpenFOAM's own checkMesh has it, and as our program says.
TEST_P(InterFoamExample, BecomesATankOfTheVolumeThatCheckMeshHas)
{
    const auto& [name, tank, dim] = GetParam();
    const InterFoamCase theCase(name);
    const std::string log = theCase.succeed("foamToSlosh -to ours");
    std::smatch ours, theirs;
    ASSERT_TRUE(std::regex_search(log, ours, std::regex(", ([0-9.e+-]+) m\\^3\n"))) << log;
    EXPECT_NE(log.find(std::to_string(dim) + "D, a " + tank), std::string::npos) << log;
    const std::string mesh = succeedInShell(theCase, "blockMesh > /dev/null; checkMesh -constant");
    ASSERT_TRUE(std::regex_search(mesh, theirs, std::regex("Total volume = ([0-9.e+-]+)\\."))) << mesh;
    EXPECT_NEAR(std::stod(ours[1]) / std::stod(theirs[1]), 1, 1e-5);

    // Its motion goes with it, and lasts.
    const std::string motionFile = "constant/dynamicMeshDict";
    EXPECT_EQ(theCase.text("ours/" + motionFile), theCase.text(motionFile));
    const auto motion = SolidBodyMotion::read(
        Dictionary::read(theCase.path() / "ours" / motionFile, motionFile), theCase.path() / "ours"
    );
    EXPECT_GE(
        motion->lastTime(),
        Dictionary::read(theCase.path() / "ours/system/controlDict", "controlDict").scalar("endTime", unit::second)
    );
    const Dictionary probes = Dictionary::read(theCase.path() / "ours/system/probesDict", "probesDict");
    EXPECT_EQ(probes.has("probes"), name != "testTubeMixer");
    if (probes.has("probes"))
    {
        EXPECT_EQ(
            probes.dict("probes").vectors("probeLocations", unit::metre),
            (std::vector<Vec>{Vec(0, 9.95, 19.77), Vec(0, -9.95, 19.77)})
        );
    }
}

INSTANTIATE_TEST_SUITE_P(
    Of, InterFoamExample,
    testing::Values(
        Example{"sloshingTank2D", "prism of 8 sides", 2}, Example{"sloshingTank2D3DoF", "prism of 8 sides", 2},
        Example{"sloshingTank3D", "prism of 8 sides", 3}, Example{"sloshingTank3D3DoF", "prism of 8 sides", 3},
        Example{"sloshingTank3D6DoF", "prism of 8 sides", 3}, Example{"testTubeMixer", "box", 3}
    ),
    [](const auto& tested) { return tested.param.name; }
);

class InterFoamCases : public testing::Test
{
protected:
    void SetUp() override
    {
        if (const std::string missing = missingForInterFoamCases(); !missing.empty())
        {
            GTEST_SKIP() << missing;
        }
    }
};

TEST_F(InterFoamCases, HaveOneThatIsRefusedForItsCurvedEdges)
{
    const InterFoamCase theCase("sloshingCylinder");
    const Ended ended = theCase.run("foamToSlosh -to ours");
    EXPECT_EQ(ended.status, 1);
    EXPECT_NE(ended.err.find("the first of 8 curved edges (project)"), std::string::npos) << ended.err;
    EXPECT_FALSE(fs::exists(theCase.path() / "ours"));
}

TEST_F(InterFoamCases, HaveOneThatRunsAsItIsConverted)
{
    const InterFoamCase theCase("testTubeMixer");
    theCase.succeed("foamToSlosh -to ours -spacing 0.0008");
    theCase.edit("ours/system/controlDict", "endTime         1;", "endTime         0.0004;");
    theCase.edit("ours/system/controlDict", "writeInterval   0.01;", "writeInterval   0.0004;");
    theCase.succeed("blockParticles -case ours");
    const std::string log = theCase.succeed("sloshSPHFoam -case ours");
    EXPECT_EQ(log.find("Not used"), std::string::npos) << log;
    EXPECT_NE(log.find("multiMotion: rotatingMotion"), std::string::npos) << log;
    EXPECT_TRUE(fs::exists(theCase.path() / "ours/0.0004"));
}

TEST(InterFoamTutorials, StopWithAClearWordWhereThePackageIsAbsent)
{
    const CaseDirectory folder;
    fs::create_directory(folder.path() / "tube");
    fs::copy(fs::path(SLOSH_SOURCE) / "tutorials/fromOpenFOAM/testTubeMixer/Allrun", folder.path() / "tube/Allrun");
    fs::copy(fs::path(SLOSH_SOURCE) / "tutorials/fromOpenFOAM/convert", folder.path() / "convert");
    const Ended ended = runInShell(folder, "SLOSH_INTERFOAM_CASES=/absent tube/Allrun");
    EXPECT_EQ(ended.status, 1);
    EXPECT_NE(ended.err.find("/absent/testTubeMixer is not there: install Debian"), std::string::npos) << ended.err;
    EXPECT_FALSE(fs::exists(folder.path() / "tube/runs"));
}

/// Their gen6DoF writes sin(omega t) of six amplitudes and frequencies: its numbers stand in its source.
TEST_F(InterFoamCases, HaveATableThatIsTheMotionItsGeneratorStates)
{
    const InterFoamCase theCase("sloshingTank3D6DoF");
    const auto motion = SolidBodyMotion::read(
        Dictionary::read(theCase.path() / "constant/dynamicMeshDict", "constant/dynamicMeshDict"), theCase.path()
    );
    const double degree = std::numbers::pi / 180;
    // The table has six digits: its times are off by 5e-5 s, in which the tank moves by 1.5e-4 m.
    constexpr double digits = 2e-4;
    for (int row = 0; row < 100; ++row)
    {
        const double t = 40.0 * row / 99;
        const RigidState state = motion->at(t);
        const Vec moved(2 * std::sin(0.5 * t), 3 * std::sin(0.8 * t), 2 * std::sin(0.4 * t));
        EXPECT_LT((state.c - moved).norm(), digits) << t;
        const Mat R = (Eigen::AngleAxisd(30 * degree * std::sin(0.4 * t), Vec::UnitX()) *
                       Eigen::AngleAxisd(10 * degree * std::sin(0.7 * t), Vec::UnitY()) *
                       Eigen::AngleAxisd(10 * degree * std::sin(0.5 * t), Vec::UnitZ()))
                          .toRotationMatrix();
        EXPECT_LT((state.R - R).norm(), digits) << t;
    }
}

} // namespace
} // namespace slosh
