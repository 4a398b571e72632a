// SPDX-License-Identifier: GPL-3.0-or-later
// Liquid that comes to rest in blockParticles and starts with a velocity.
#include "CaseDirectory.hpp"
#include "samples.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace slosh
{
namespace
{

TEST(SettledStart, HasTheSameBitsAtAnyNumberOfThreadsAndIsThenSetInMotion)
{
    const CaseDirectory theCase;
    theCase.write("system/blockParticlesDict", theCase.text("system/blockParticlesDict") + R"(settle { time 0.1; }
initialFields { U ("0" "0.5*z" "0"); }
)");
    CaseDirectory other;
    other.copyFrom(theCase);
    EXPECT_NE(theCase.succeed("blockParticles -threads 1").find("Settled in"), std::string::npos);
    other.succeed("blockParticles -threads 4");
    for (const std::string file : {"positions", "U", "p", "rho", "origId"})
    {
        EXPECT_TRUE(theCase.text("0/lagrangian/fluid/" + file) == other.text("0/lagrangian/fluid/" + file)) << file;
    }

    theCase.succeed("particlesToVTK -format csv -time 0 -noWall -frame tank -fields '(U)'");
    std::string csv = "#" + theCase.text("postProcessing/particles/0/fluid.csv"); // x,y,z,U_x,U_y,U_z
    std::replace(csv.begin(), csv.end(), ',', ' ');
    const auto rows = rowsOf(csv);
    ASSERT_EQ(rows.size(), 200u);
    int moved = 0; // from the lattice, whose heights are 0.005, 0.015 ... m
    for (const auto& row : rows)
    {
        EXPECT_NEAR(row[4], 0.5 * row[2], 1e-6);
        moved += std::abs(std::remainder(row[2] - 0.005, 0.01)) > 1e-6;
    }
    EXPECT_GT(moved, 100);
}

TEST(SettledStart, OfASchemeIsLeftOutWithoutGravityAndThatOfTheCaseIsRefused)
{
    const CaseDirectory theCase;
    theCase.edit("constant/g", "(0 0 -9.81)", "(0 0 0)");
    theCase.write("system/sphSchemes", "scheme smallWaves;\n");
    EXPECT_NE(
        theCase.succeed("blockParticles").find("\nNot settled: scheme smallWaves: settle needs gravity and walls"),
        std::string::npos
    );
    theCase.write("system/blockParticlesDict", theCase.text("system/blockParticlesDict") + "settle { time 0.1; }\n");
    const Ended ended = theCase.run("blockParticles");
    EXPECT_EQ(ended.status, 1);
    EXPECT_NE(ended.err.find("settle needs gravity and walls"), std::string::npos) << ended.err;
}

} // namespace
} // namespace slosh
