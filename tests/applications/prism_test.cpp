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
    void tank(const std::string& polygon, const std::string& fill, const std::string& plane = "plane yz; ") const
    {
        case_.write("constant/tankProperties", "FoamFile { version 2.0; format ascii; class dictionary; }\ntype prism; " +
                                                   plane + "section yz;\nextent (-0.5 0.5);\npolygon (" + polygon +
                                                   ");\n" + fill + "\n");
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

const std::string chamfered = "(-0.1 0.04) (-0.06 0) (0.06 0) (0.1 0.04) (0.1 0.12) (0.07 0.15) (-0.07 0.15) (-0.1 0.12)";

TEST_F(PrismCase, StillWaterInAChamferedTankStaysStillAndPressesOnEverySideWithItsDepth)
{
    tank(chamfered, "fillDepth 0.1;");
    probes("(0 0 0) (0 0.08 0.02) (0 -0.08 0.02) (0 0.1 0.07) (0 0 0.05)");
    still(1.5);
    const std::string said = case_.succeed("blockParticles");
    EXPECT_NE(said.find("a box of the still surface's breadth and the tank's depth"), std::string::npos) << said;
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
    EXPECT_LT(energy(0, 1.5, mgD), 1e-4);
    EXPECT_LT(energy(0.75, 1.5, mgD), energy(0, 0.75, mgD));
}

TEST_F(PrismCase, WaterOverAnAcuteBottomAndAReflexCornerStaysStillAndInsideAndBearsAHarshRoll)
{
    struct Section
    {
        std::string polygon;
        double area, depth;
    };
    // A hull of 30 degrees, a step whose edges are at 135 and 225 degrees.
    for (const Section& section : {Section{"(0 0) (0.04019 0.15) (-0.04019 0.15)", 0.00268 * 1, 0.1},
                                   Section{"(-0.1 0) (-0.02 0) (0.02 0.04) (0.1 0.04) (0.1 0.15) (-0.1 0.15)", 0.016, 0.1}})
    {
        CaseDirectory rolling;
        tank(section.polygon, "fillDepth " + std::to_string(section.depth) + ";");
        probes("(0 0 0.1)");
        case_.edit("system/blockParticlesDict", "0.01", "0.005");
        rolling.copyFrom(case_);
        still(0.5);
        case_.succeed("blockParticles");
        case_.succeed("sloshSPHFoam");
        EXPECT_LT(energy(0, 0.5, 1000 * section.area * 9.81 * section.depth), 5e-4) << section.polygon;

        rolling.edit("constant/dynamicMeshDict", "amplitude (8 0 0)", "amplitude (20 0 0)");
        rolling.edit("system/controlDict", "endTime 0.1", "endTime 0.8");
        rolling.edit("system/controlDict", "writeInterval 0.05", "writeInterval 0.8");
        rolling.succeed("blockParticles");
        rolling.succeed("sloshSPHFoam"); // particlesOutside 0 by default
        const auto count = [&](const std::string& time)
        {
            const std::string text = rolling.text(time + "/uniform/lagrangian/fluid/cloudProperties");
            return text.substr(text.find("particleCount"));
        };
        EXPECT_EQ(count("0.8"), count("0"));
        rolling.remove("");
        case_.copyFrom(CaseDirectory());
    }
}

} // namespace
} // namespace slosh
