// SPDX-License-Identifier: GPL-3.0-or-later
// The stillTank tutorials in quick form: water in a tank at rest stays at rest and presses with rho g h.
#include "CaseDirectory.hpp"
#include "samples.hpp"

#include <gtest/gtest.h>

namespace slosh
{
namespace
{

void expectStillWater(const CaseDirectory& theCase, double depthOfProbe, double mgD)
{
    theCase.remove("constant/dynamicMeshDict");
    theCase.edit("system/controlDict", "endTime 0.1", "endTime 1.5");
    theCase.edit("system/controlDict", "writeInterval 0.05", "writeInterval 1.5");
    theCase.succeed("blockParticles");
    theCase.succeed("sloshSPHFoam");

    // The start rings at the sound's period of 4 D/c0 until viscosity has taken it: the last third is compared.
    double mean = 0;
    int n = 0;
    for (const auto& row : rowsOf(theCase.text("postProcessing/pressure/0/p")))
    {
        if (row[0] > 1)
        {
            mean += row[1];
            ++n;
        }
    }
    ASSERT_GT(n, 40);
    EXPECT_NEAR(mean / n, 1000 * 9.81 * depthOfProbe, 0.01 * 1000 * 9.81 * depthOfProbe);

    double early = 0, late = 0;
    for (const auto& row : rowsOf(theCase.text("postProcessing/energies/0/energies.dat")))
    {
        EXPECT_LT(row[1], 1e-4 * mgD) << "at " << row[0] << " s";
        (row[0] < 0.75 ? early : late) = std::max(row[0] < 0.75 ? early : late, row[1]);
    }
    EXPECT_LT(late, early);
    const auto count = [&](const std::string& time)
    {
        const std::string text = theCase.text(time + "/uniform/lagrangian/fluid/cloudProperties");
        return text.substr(text.find("particleCount"));
    };
    EXPECT_EQ(count("1.5"), count("0"));
}

TEST(StillWater, InTwoDimensionsStaysStillAndPressesWithItsDepth)
{
    const CaseDirectory theCase;
    expectStillWater(theCase, 0.05, 20 * 9.81 * 0.1);
}

TEST(StillWater, InThreeDimensionsStaysStillAndPressesWithItsDepth)
{
    const CaseDirectory theCase;
    theCase.edit(
        "constant/tankProperties", "plane yz;\nmin (-0.5 -0.1 0);\nmax (0.5 0.1 0.15)",
        "min (-0.05 -0.1 0);\nmax (0.05 0.1 0.15)"
    );
    theCase.edit("system/blockParticlesDict", "0.01", "0.0125");
    expectStillWater(theCase, 0.05, 2 * 9.81 * 0.1);
}

} // namespace
} // namespace slosh
