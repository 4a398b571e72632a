// SPDX-License-Identifier: GPL-3.0-or-later
// Probes with a face as a user has them: what a run, probeSample and the programs that read samples make of them.
#include "CaseDirectory.hpp"
#include "samples.hpp"

#include <gtest/gtest.h>

namespace slosh
{
namespace
{

/// The small tank, its liquid disturbed by its motion for two written times.
class ProbesWithAFace : public testing::Test
{
protected:
    void SetUp() override
    {
        case_.write("system/blockParticlesDict", "particleSpacing 0.02;\n");
        case_.edit("system/controlDict", "endTime 0.1", "endTime 0.02");
        case_.edit("system/controlDict", "writeInterval 0.05", "writeInterval 0.01");
        case_.edit("system/controlDict", "fields (p);", "fields (p); radius 0.03;");
        case_.succeed("blockParticles");
    }

    CaseDirectory case_;
};

TEST_F(ProbesWithAFace, AreTheSameInTheRunAndInProbeSample)
{
    case_.succeed("sloshSPHFoam");
    case_.succeed("probeSample");
    const std::string inRun = case_.text("postProcessing/pressure/0/p");
    EXPECT_NE(
        inRun.find("# Probe 1 (0 0.1 0.05)\n# Probe 2 (0 0.1 0.14)\n"
                   "# Mean over a face in the wall: disc of radius 0.03 m\n"),
        std::string::npos
    ) << inRun;
    const auto run = rowsOf(inRun), sampled = rowsOf(case_.text("postProcessing/probeSample/pressure/0/p"));
    ASSERT_EQ(run.size(), 3u);
    ASSERT_EQ(sampled.size(), 3u);
    for (std::size_t k = 0; k < 3; ++k)
    {
        ASSERT_EQ(run[k].size(), 4u);
        for (std::size_t i = 0; i < 4; ++i)
        {
            EXPECT_NEAR(sampled[k][i], run[k][i], 1e-7 * run[k][i]);
        }
    }
    EXPECT_NE(run[2][1], run[2][2]) << "the tank rolls";
}

TEST_F(ProbesWithAFace, AreReadAsOthersAre)
{
    case_.succeed("sloshSPHFoam");
    const std::string listed = case_.succeed("sloshMonitor -list");
    EXPECT_NE(listed.find("p0 (0 -0.1 0.05), p1 (0 0.1 0.05), p2 (0 0.1 0.14)"), std::string::npos) << listed;
    case_.write(
        "system/comparisonsDict", "start { samples pressure/p; column 1; quantity value; time 0; reference { type "
                                  "stated; value 490.5; } bound 0.01; }"
    );
    case_.succeed("compareSamples");
    case_.write("system/peakStatisticsDict", "left { samples pressure/p; threshold 0; separation 0; }");
    case_.succeed("peakStatistics");
}

TEST_F(ProbesWithAFace, AreRefusedInTheLiquid)
{
    case_.edit("system/controlDict", "(0 0.1 0.05)", "(0 0 0.05)");
    const Ended ended = case_.run("sloshSPHFoam");
    EXPECT_EQ(ended.status, 1);
    for (const std::string fragment :
         {"radius gives probes a face, which must lie on a wall; (0 0 0.05) is 0.05 m from", "system/controlDict:"})
    {
        EXPECT_NE(ended.err.find(fragment), std::string::npos) << ended.err;
    }
}

} // namespace
} // namespace slosh
