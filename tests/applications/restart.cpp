// SPDX-License-Identifier: GPL-3.0-or-later
#include "restart.hpp"

#include "samples.hpp"

#include <gtest/gtest.h>

namespace slosh
{

namespace fs = std::filesystem;

void expectSameState(const CaseDirectory& a, const CaseDirectory& b, const std::string& time)
{
    for (const std::string cloud : {"fluid", "wall"})
    {
        int fields = 0;
        for (const auto& item : fs::directory_iterator(a.path() / time / "lagrangian" / cloud))
        {
            const std::string file = time + "/lagrangian/" + cloud + "/" + item.path().filename().string();
            EXPECT_TRUE(a.text(file) == b.text(file)) << file;
            ++fields;
        }
        EXPECT_GE(fields, 5); // positions U p rho origId
    }
    EXPECT_EQ(a.text(time + "/uniform/time"), b.text(time + "/uniform/time"));
    EXPECT_EQ(a.text(time + "/uniform/tankState"), b.text(time + "/uniform/tankState"));
    EXPECT_EQ(a.text(time + "/uniform/energyBudget"), b.text(time + "/uniform/energyBudget"));
}

void expectRestartContinuesBitForBit(const CaseDirectory& whole, const std::string& threads)
{
    whole.succeed("blockParticles");
    CaseDirectory stopped;
    stopped.copyFrom(whole);
    whole.succeed("sloshSPHFoam -threads 2");

    stopped.edit("system/controlDict", "endTime 0.1", "endTime 0.05");
    stopped.succeed("sloshSPHFoam -threads 2");
    stopped.edit("system/controlDict", "endTime 0.05", "endTime 0.1");
    stopped.succeed("sloshSPHFoam -threads " + threads);
    expectSameState(whole, stopped, "0.1");
    for (const std::string file :
         {"pressure/*/p", "gauges/*/height.dat", "forces/*/force.dat", "energies/*/energies.dat"})
    {
        const auto star = file.find('*');
        const auto named = [&](const std::string& start)
        { return "postProcessing/" + file.substr(0, star) + start + file.substr(star + 1); };
        EXPECT_EQ(
            samplesOf(whole.text(named("0"))),
            samplesOf(stopped.text(named("0"))) + samplesOf(stopped.text(named("0.05")))
        ) << file;
    }
}

} // namespace slosh
