// SPDX-License-Identifier: GPL-3.0-or-later
// probeSample and particlesToVTK on a case that has run.
#include "CaseDirectory.hpp"
#include "samples.hpp"

#include <gtest/gtest.h>

namespace slosh
{
namespace
{

namespace fs = std::filesystem;

class Tools : public testing::Test
{
protected:
    void SetUp() override
    {
        case_.succeed("blockParticles");
        case_.succeed("sloshSPHFoam");
    }

    CaseDirectory case_;
};

TEST_F(Tools, ProbeSampleGivesWhatTheRunSampled)
{
    const std::string log = case_.succeed("probeSample");
    EXPECT_NE(log.find("postProcessing/probeSample/pressure/0/p"), std::string::npos) << log;
    for (const std::string file :
         {"pressure/0/p", "gauges/0/height.dat", "forces/0/force.dat", "energies/0/energies.dat"})
    {
        const auto online = rowsOf(case_.text("postProcessing/" + file));
        const auto afterwards = rowsOf(case_.text("postProcessing/probeSample/" + file));
        ASSERT_EQ(afterwards.size(), 3u) << file; // 0, 0.05, 0.1 of 0, 0.01 ... 0.1
        // Time 0 was written by blockParticles, which does not know how far particles move in a step: its lists, longer
        // or shorter than those of the run, round the sums over them (195 N) otherwise.
        ASSERT_EQ(afterwards[0].size(), online[0].size()) << file;
        for (std::size_t k = 0; k < online[0].size(); ++k)
        {
            EXPECT_NEAR(afterwards[0][k], online[0][k], 1e-5) << file << ", column " << k;
        }
        for (std::size_t i = 1; i < 3; ++i)
        {
            EXPECT_EQ(afterwards[i], online[5 * i]) << file;
        }
    }
}

TEST_F(Tools, ProbeSampleTakesProbesAddedAfterwards)
{
    case_.write("system/later", "later { type probes; fields (p); probeLocations ((0 0 0)); }\n");
    case_.succeed("probeSample -dict system/later -time 0.05:");
    const auto rows = rowsOf(case_.text("postProcessing/probeSample/later/0.05/p"));
    ASSERT_EQ(rows.size(), 2u);
    EXPECT_GT(rows[0][1], 500);
}

TEST_F(Tools, ForcesAreThoseOfTheirPatches)
{
    case_.write(
        "system/parts", "all { type forces; }\nwalls { type forces; patches (walls); }\nnone { type forces; patches "
                        "(walls leftWall); }\n"
    );
    const Ended refused = case_.run("probeSample -dict system/parts");
    EXPECT_EQ(refused.status, 1);
    EXPECT_NE(refused.err.find("leftWall"), std::string::npos) << refused.err;
    EXPECT_NE(refused.err.find("walls"), std::string::npos) << refused.err;
    case_.write("system/parts", "all { type forces; }\nwalls { type forces; patches (walls); }\n");
    case_.succeed("probeSample -dict system/parts");
    const auto all = rowsOf(case_.text("postProcessing/probeSample/all/0/force.dat"));
    EXPECT_EQ(all, rowsOf(case_.text("postProcessing/probeSample/walls/0/force.dat")));
    EXPECT_EQ(all.at(0).size(), 13u); // time, total, pressure, viscous, stops
}

TEST_F(Tools, ParticlesToVTKNamesWhatItWrites)
{
    const std::string log = case_.succeed("particlesToVTK -time 0.05:0.1");
    std::istringstream lines(log);
    int named = 0;
    for (std::string line; std::getline(lines, line);)
    {
        if (line.rfind("    VTK/", 0) == 0)
        {
            ++named;
            EXPECT_TRUE(fs::exists(case_.path() / line.substr(4))) << line;
        }
    }
    EXPECT_EQ(named, 9) << log; // two times fluid, wall, tank, and three series
    EXPECT_EQ(std::distance(fs::directory_iterator(case_.path() / "VTK"), {}), 9);
    EXPECT_NE(case_.text("VTK/fluid.vtu.series").find("\"time\" : 0.05 }"), std::string::npos);
    EXPECT_EQ(case_.text("VTK/fluid.vtu.series").find("\"time\" : 0 }"), std::string::npos);
}

TEST_F(Tools, ParticlesToVTKShowsTheTankMoveOrStayPut)
{
    case_.succeed("particlesToVTK -format csv -latestTime -frame inertial");
    const std::string moved = case_.text("postProcessing/particles/0.1/tank.csv");
    case_.succeed("particlesToVTK -format csv -latestTime -frame tank");
    const std::string still = case_.text("postProcessing/particles/0.1/tank.csv");
    EXPECT_NE(still.find("0,-0.1,0\n"), std::string::npos) << still;
    EXPECT_EQ(moved.find("0,-0.1,0\n"), std::string::npos) << moved;
}

TEST_F(Tools, ParticlesToVTKComputesTheVorticityWhenAsked)
{
    case_.succeed("particlesToVTK -format csv -latestTime -fields '(vorticity p)'");
    EXPECT_EQ(
        case_.text("postProcessing/particles/0.1/fluid.csv").rfind("x,y,z,vorticity_x,vorticity_y,vorticity_z,p\n", 0),
        0U
    );
    case_.succeed("particlesToVTK -latestTime -fields '(vorticity)'");
}

TEST_F(Tools, FieldThatDoesNotExistIsRefused)
{
    const Ended ended = case_.run("particlesToVTK -fields '(p V)'");
    EXPECT_EQ(ended.status, 1);
    EXPECT_NE(ended.err.find("unknown field 'V'"), std::string::npos) << ended.err;
    EXPECT_FALSE(fs::exists(case_.path() / "VTK"));
}

} // namespace
} // namespace slosh
