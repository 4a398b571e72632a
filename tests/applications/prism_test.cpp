// SPDX-License-Identifier: GPL-3.0-or-later
// Tanks of polygonal section as a user runs them.
#include "CaseDirectory.hpp"
#include "samples.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace slosh
{
namespace
{

/// The case's tank, 0.2 m x 0.15 m, in the yz plane, with this section instead.
class PrismCase : public testing::Test
{
protected:
    void SetUp() override { case_.edit("system/controlDict", "locations ((0 0 0))", "locations ((0 0 0.12))"); }
    void tank(const std::string& polygon, const std::string& fill, const std::string& plane = "plane yz; ") const
    {
        case_.write(
            "constant/tankProperties", "FoamFile { version 2.0; format ascii; class dictionary; }\ntype prism; " +
                                           plane + "section yz;\nextent (-0.5 0.5);\npolygon (" + polygon + ");\n" +
                                           fill + "\n"
        );
    }
    void probes(const std::string& locations) const
    {
        const std::string text = case_.text("system/controlDict");
        const auto from = text.find("(0 -0.1 0.05)");
        const auto to = text.find("(0 0.1 0.14)");
        case_.edit("system/controlDict", text.substr(from, to + 12 - from), locations);
    }
    void still(double endTime) const
    {
        case_.remove("constant/dynamicMeshDict");
        case_.edit("system/controlDict", "endTime 0.1", "endTime " + std::to_string(endTime));
        case_.edit("system/controlDict", "writeInterval 0.05", "writeInterval " + std::to_string(endTime));
    }
    /// Largest kinetic energy between two times over m g D.
    double energy(double from, double to, double mgD) const
    {
        double most = 0;
        for (const auto& row : rowsOf(case_.text("postProcessing/energies/0/energies.dat")))
        {
            most = row[0] >= from && row[0] <= to ? std::max(most, row[1]) : most;
        }
        return most / mgD;
    }
    CaseDirectory case_;
};

const std::string chamfered =
    "(-0.1 0.04) (-0.06 0) (0.06 0) (0.1 0.04) (0.1 0.12) (0.07 0.15) (-0.07 0.15) (-0.1 0.12)";

TEST_F(PrismCase, StillWaterInAChamferedTankStaysStillAndPressesOnEverySideWithItsDepth)
{
    tank(chamfered, "fillDepth 0.1;");
    probes("(0 0 0) (0 0.08 0.02) (0 -0.08 0.02) (0 0.1 0.07) (0 0 0.05)");
    still(1.5);
    const std::string said = case_.succeed("blockParticles");
    EXPECT_NE(said.find("a box with the breadth of the still surface and the depth of the tank"), std::string::npos)
        << said;
    case_.succeed("sloshSPHFoam");
    const std::vector<double> depths = {0.1, 0.08, 0.08, 0.03, 0.05};
    std::vector<double> means(depths.size());
    int n = 0;
    for (const auto& row : rowsOf(case_.text("postProcessing/pressure/0/p")))
    {
        if (row[0] > 1)
        {
            ++n;
            for (std::size_t k = 0; k < depths.size(); ++k)
            {
                means[k] += row[1 + k];
            }
        }
    }
    ASSERT_GT(n, 40);
    for (std::size_t k = 0; k < depths.size(); ++k)
    {
        EXPECT_NEAR(means[k] / n, 9810 * depths[k], 0.015 * 981) << "probe " << k;
    }
    const double mgD = 1000 * (0.2 * 0.1 - 0.0016) * 9.81 * 0.1;
    EXPECT_LT(energy(0, 1.5, mgD), 1e-4); // as between the walls of a box
    EXPECT_LT(energy(1, 1.5, mgD), 1e-5); // v of 0.004 sqrt(g D)
}

/// Sections for what is hard: a hull of 30 degrees, a step with corners of 135 and 225 degrees.
const std::vector<std::string> hard = {
    "(0 0) (0.06699 0.25) (-0.06699 0.25)", "(-0.1 0) (-0.02 0) (0.02 0.04) (0.1 0.04) (0.1 0.15) (-0.1 0.15)"};

TEST_F(PrismCase, WaterOverAnAcuteBottomOrAReflexCornerStaysStill)
{
    probes("(0 0 0.05)");
    still(0.5);
    for (const std::string& section : hard)
    {
        tank(section, "fillDepth 0.1;");
        case_.succeed("blockParticles");
        case_.succeed("sloshSPHFoam"); // and stops where a particle is outside
        EXPECT_LT(energy(0, 0.5, 0.00268 * 1000 * 9.81 * 0.1), 1e-4) << section;
        double mean = 0;
        int n = 0;
        for (const auto& row : rowsOf(case_.text("postProcessing/pressure/0/p")))
        {
            mean += row[0] > 0.25 ? row[1] : 0;
            n += row[0] > 0.25 ? 1 : 0;
        }
        EXPECT_NEAR(mean / n, 9810 * 0.05, 0.03 * 981) << section;
        case_.remove("postProcessing");
        case_.remove("0.5");
    }
}

TEST_F(PrismCase, NoParticleIsLostInAHarshRollOverThem)
{
    probes("(0 0 0.1)");
    case_.edit("constant/dynamicMeshDict", "amplitude (8 0 0)", "amplitude (25 0 0)");
    case_.edit("system/controlDict", "endTime 0.1", "endTime 0.8");
    case_.edit("system/controlDict", "writeInterval 0.05", "writeInterval 0.8");
    for (const std::string& section : hard)
    {
        tank(section, "fillDepth 0.1;");
        case_.succeed("blockParticles");
        case_.succeed("sloshSPHFoam"); // stops where a particle is outside
        const auto count = [&](const std::string& time)
        {
            const std::string text = case_.text(time + "/uniform/lagrangian/fluid/cloudProperties");
            return text.substr(text.find("particleCount"));
        };
        EXPECT_EQ(count("0.8"), count("0")) << section;
        double most = 0;
        for (const auto& row : rowsOf(case_.text("postProcessing/energies/0/energies.dat")))
        {
            most = std::max(most, row[1]);
        }
        EXPECT_GT(most, 0.02) << section; // it does move
        case_.remove("postProcessing");
        case_.remove("0.8");
    }
}

TEST_F(PrismCase, In3DStartsStillAndIsShownInItsShape)
{
    tank("(-0.1 0.05) (-0.05 0) (0.05 0) (0.1 0.05) (0.1 0.15) (-0.1 0.15)", "fillDepth 0.1;", "");
    case_.edit("constant/tankProperties", "extent (-0.5 0.5)", "extent (-0.05 0.05)");
    case_.edit("system/blockParticlesDict", "0.01", "0.0125");
    probes("(0 0 0.05) (0.05 0.075 0.025)");
    still(0.25);
    case_.succeed("blockParticles");
    case_.succeed("sloshSPHFoam");
    EXPECT_LT(energy(0, 0.25, 1000 * (0.02 - 0.0025) * 0.1 * 9.81 * 0.1), 1e-4);
    const auto rows = rowsOf(case_.text("postProcessing/pressure/0/p"));
    double onSide = 0;
    for (const auto& row : rows)
    {
        onSide += row[2] / static_cast<double>(rows.size());
    }
    EXPECT_NEAR(onSide, 9810 * 0.075, 0.03 * 981); // in the corner of a slanted side and an end
    case_.succeed("particlesToVTK -frame tank -surface -time 0");
    const std::string outline = case_.text("VTK/tank_0.vtp");
    EXPECT_NE(outline.find("NumberOfPoints=\"12\""), std::string::npos) << outline.substr(0, 400);
    EXPECT_NE(outline.find("NumberOfLines=\"18\""), std::string::npos) << outline.substr(0, 400);
}

TEST_F(PrismCase, WhoseSectionIsARectangleGivesTheFilesOfTheBox)
{
    CaseDirectory box;
    box.succeed("blockParticles");
    tank("(-0.1 0.15) (-0.1 0) (0.1 0) (0.1 0.15)", "fillDepth 0.1;");
    case_.succeed("blockParticles");
    for (const std::string cloud : {"fluid/", "wall/"})
    {
        for (const std::string file : {"positions", "U", "p", "rho", "origId"})
        {
            const std::string name = "0/lagrangian/" + cloud + file;
            EXPECT_TRUE(case_.text(name) == box.text(name)) << name;
        }
    }
}

TEST_F(PrismCase, IsRefusedWithTheLineAndTheRemedy)
{
    const auto expect = [&](const std::string& polygon, const std::string& message)
    {
        tank(polygon, "fillDepth 0.1;");
        const Ended ended = case_.run("blockParticles");
        EXPECT_EQ(ended.status, 1);
        EXPECT_NE(ended.err.find(message), std::string::npos) << ended.err;
    };
    expect(
        "(0 0) (0.1 0.15) (0.1 0) (0 0.15)", "constant/tankProperties:4: polygon intersects itself: the side (0 0) to "
                                             "(0.1 0.15) meets the side (0.1 0) to (0 "
                                             "0.15)"
    );
    expect(
        "(-0.1 0) (-0.01 0) (-0.01 0.1) (0.01 0.1) (0.01 0) (0.1 0) (0.1 0.15) (-0.1 0.15)",
        "is 0.02 m thick at the corner (-0.01     0), less than the kernel's support of 0.0369 m: liquid on its two "
        "sides would interact"
    );
    tank(chamfered, "fillDepth 0.1;");
    case_.succeed("blockParticles");
    probes("(0 0.1 0.01)"); // in the chamfer's corner of the box
    const Ended ended = case_.run("sloshSPHFoam");
    EXPECT_EQ(ended.status, 1);
    EXPECT_NE(ended.err.find("outside the tank, a prism within"), std::string::npos) << ended.err;
}

} // namespace
} // namespace slosh
