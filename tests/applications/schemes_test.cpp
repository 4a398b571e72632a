// SPDX-License-Identifier: GPL-3.0-or-later
// Cases that leave kernel, viscosity, walls, diffusion and integrator to their scheme; friction at walls that slip.
#include "CaseDirectory.hpp"
#include "restart.hpp"
#include "samples.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace slosh
{
namespace
{

namespace fs = std::filesystem;

/// The recommended scheme with friction at the bottom and the ends and of the side walls.
void makeFrictional(const CaseDirectory& theCase)
{
    theCase.write("system/sphSchemes", "frame tank;\n");
    theCase.write(
        "constant/fluidProperties", "rho0 1000; friction { type boundaryLayer; nu 1e-4; sideWalls { breadth "
                                    "0.05; } }\n"
    );
    theCase.remove("constant/kernelProperties");
}

TEST(RecommendedScheme, RestartedWithFrictionContinuesBitForBit)
{
    const CaseDirectory frictional;
    makeFrictional(frictional);
    expectRestartContinuesBitForBit(frictional, "4");
    EXPECT_TRUE(fs::exists(frictional.path() / "0.1/lagrangian/wall/layerMemory7"));
    EXPECT_TRUE(fs::exists(frictional.path() / "0.1/lagrangian/fluid/meanDiffusion"));
}

TEST(RecommendedScheme, WithFrictionClosesItsEnergyBudgetAndProbeSampleHasItsForces)
{
    const CaseDirectory frictional;
    makeFrictional(frictional);
    // With the step of the scheme, twice that, its error is 0.7 % of the little work of 0.1 s; with this one 0.03 %.
    frictional.write("system/controlDict", frictional.text("system/controlDict") + "maxCo 0.4;\n");
    frictional.succeed("blockParticles");
    EXPECT_NE(frictional.succeed("sloshSPHFoam").find("viscosity/walls slip (scheme recommended)"), std::string::npos);
    const auto rows = rowsOf(frictional.text("postProcessing/energies/0/energies.dat"));
    const double work = rows.back()[6];
    EXPECT_GT(rows.back()[7], 1e-3 * work) << "friction takes nothing";
    EXPECT_NEAR(rows.back()[12] / work, 0, 2e-3);

    const auto online = rowsOf(frictional.text("postProcessing/forces/0/force.dat"));
    EXPECT_GT(std::abs(online.back()[8]), 1e-3) << "no friction along the bottom";
    frictional.succeed("probeSample");
    EXPECT_EQ(rowsOf(frictional.text("postProcessing/probeSample/forces/0/force.dat")).back(), online.back());
}

TEST(Schemes, LetStillWaterNeitherRiseNorSink)
{
    for (const std::string scheme : {"recommended", "smallWaves"})
    {
        CaseDirectory still;
        still.write("constant/tankProperties", "plane xz; min (-0.2 -0.5 0); max (0.2 0.5 0.2); fillDepth 0.1;\n");
        still.write("constant/fluidProperties", "rho0 1000;\n");
        still.remove("constant/kernelProperties");
        still.remove("constant/dynamicMeshDict");
        still.write("system/sphSchemes", "scheme " + scheme + ";\n");
        still.write(
            "system/controlDict",
            "endTime 20; adjustTimeStep yes; writeControl adjustableRunTime; writeInterval 20; functions { "
            "pressure { type probes; fields (p); probeLocations ((-0.2 0 0.05)); writeControl runTime; "
            "writeInterval 0.02; } com { type centreOfMass; writeControl runTime; writeInterval 0.1; } }\n"
        );
        still.succeed("blockParticles");
        still.succeed("sloshSPHFoam");
        double sum = 0, n = 0;
        for (const auto& row : rowsOf(still.text("postProcessing/pressure/0/p")))
        {
            sum += row[0] > 5 ? row[1] : 0;
            n += row[0] > 5 ? 1 : 0;
        }
        EXPECT_NEAR(sum / n / 490.5, 1, 3e-3) << scheme;
        // Its centre of mass moves by less than 1e-4 of the depth in the last 15 s.
        const auto centre = rowsOf(still.text("postProcessing/com/0/centreOfMass.dat"));
        EXPECT_NEAR(centre.back()[3], centre[50][3], 1e-5) << scheme;
        EXPECT_NEAR(centre.back()[3], 0.05, 1e-4) << scheme;
    }
}

/// The rate at which the amplitude of the first mode falls, by the peaks of its kinetic energy, [1/s].
double rateOfDecay(const std::string& friction)
{
    CaseDirectory wave;
    wave.write("constant/tankProperties", "plane xz; min (0 -0.031 0); max (0.9 0.031 0.3); fillDepth 0.093;\n");
    wave.write("constant/fluidProperties", "rho0 1000; equationOfState { speedOfSound 12; } " + friction + "\n");
    wave.remove("constant/kernelProperties");
    wave.remove("constant/dynamicMeshDict");
    wave.write("system/sphSchemes", "scheme recommended;\n");
    wave.write(
        "system/blockParticlesDict",
        "particleSpacing 0.0093; initialFields { U (\"-0.03*cosh(3.490659*z)/cosh(0.32463)*sin(3.490659*x)\" "
        "\"0\" \"0.03*sinh(3.490659*z)/cosh(0.32463)*cos(3.490659*x)\"); }\n"
    );
    wave.write(
        "system/controlDict",
        "endTime 10; adjustTimeStep yes; writeControl adjustableRunTime; writeInterval 10; functions { "
        "energies { type energies; writeControl runTime; writeInterval 0.02; } }\n"
    );
    wave.succeed("blockParticles");
    wave.succeed("sloshSPHFoam -threads 1");
    const auto rows = rowsOf(wave.text("postProcessing/energies/0/energies.dat"));
    // Twice a period of 1.917 s; the first are left out, while particles find their places.
    double n = 0, sumT = 0, sumA = 0, sumTT = 0, sumTA = 0;
    for (double begin = 1.2; begin < 9; begin += 1.917 / 2)
    {
        double energy = 0, t = 0;
        for (const auto& row : rows)
        {
            if (row[0] > begin && row[0] < begin + 1.917 / 2 && row[1] > energy)
            {
                energy = row[1];
                t = row[0];
            }
        }
        const double a = std::log(energy) / 2;
        n += 1;
        sumT += t;
        sumA += a;
        sumTT += t * t;
        sumTA += t * a;
    }
    return -(n * sumTA - sumT * sumA) / (n * sumTT - sumT * sumT);
}

TEST(Friction, DampsASmallWaveAtTheRateOfStokesLayers)
{
    // Side walls k/2, k = 2 sqrt(nu omega/2)/B; bottom sqrt(nu omega/2) k/sinh 2kh; ends 1e-4/s.
    const double omega = 3.2775, kh = 0.32463, layer = std::sqrt(1e-6 * omega / 2);
    const double theory = layer / 0.062 + layer * 3.490659 / std::sinh(2 * kh) + 1e-4;
    const double slip = rateOfDecay("");
    const double frictional = rateOfDecay("friction { type boundaryLayer; nu 1e-6; sideWalls { breadth 0.062; } }");
    EXPECT_GT(slip, 0);
    EXPECT_NEAR((frictional - slip) / theory, 1, 0.3);
}

/// The rate at which the quarter wave of sound in a column 0.1 m deep falls, by the peaks of its kinetic energy, and
/// its period.
std::pair<double, double> soundInAColumn(const std::string& damping)
{
    CaseDirectory column;
    column.write("constant/tankProperties", "plane xz; min (0 -0.5 0); max (0.2 0.5 0.2); fillDepth 0.1;\n");
    column.write("constant/fluidProperties", "rho0 1000; equationOfState { speedOfSound 12; }\n");
    column.remove("constant/kernelProperties");
    column.remove("constant/dynamicMeshDict");
    column.write(
        "system/sphSchemes", "scheme recommended; wall { suction yes; } soundDamping { type " + damping + "; }\n"
    );
    column.write(
        "system/blockParticlesDict",
        "particleSpacing 0.0025; initialFields { U (\"0\" \"0\" \"0.02*sin(15.707963*z)\"); }\n"
    );
    column.write(
        "system/controlDict",
        "endTime 0.1; adjustTimeStep yes; writeControl adjustableRunTime; writeInterval 0.1; functions { "
        "energies { type energies; writeControl timeStep; writeInterval 1; } }\n"
    );
    column.succeed("blockParticles");
    column.succeed("sloshSPHFoam -threads 1");
    std::vector<std::pair<double, double>> peaks; // time, kinetic energy
    const auto rows = rowsOf(column.text("postProcessing/energies/0/energies.dat"));
    for (std::size_t i = 1; i + 1 < rows.size() && peaks.size() < 4; ++i)
    {
        if (rows[i][1] > rows[i - 1][1] && rows[i][1] >= rows[i + 1][1])
        {
            peaks.emplace_back(rows[i][0], rows[i][1]);
        }
    }
    const double halves = static_cast<double>(peaks.size() - 1);
    const double passed = peaks.back().first - peaks.front().first;
    return {std::log(peaks.front().second / peaks.back().second) / 2 / passed, 2 * passed / halves};
}

TEST(SoundDamping, IsThatOfABulkViscosityAQuarterOfTheDepthTimesTheSpeedOfSound)
{
    const auto [without, period] = soundInAColumn("none");
    const auto [with, damped] = soundInAColumn("coarse");
    EXPECT_NEAR(period / (4 * 0.1 / 12), 1, 0.03);
    // nu k^2/2, nu = c0 d/4, with the k that the column shows; the grid's interpolation and the surface leave 3 % out.
    const double theory = 12 * 0.1 / 4 * std::pow(2 * std::numbers::pi / (12 * period), 2) / 2;
    EXPECT_NEAR((with - without) / (0.97 * theory), 1, 0.05);
    EXPECT_NEAR(damped / period, 1 / std::sqrt(1 - std::pow(with * period / (2 * std::numbers::pi), 2)), 0.01);
}

} // namespace
} // namespace slosh
