// SPDX-License-Identifier: GPL-3.0-or-later
// Cases after public bug reports and other people's files, each with its right value.
#include "CaseDirectory.hpp"

#include <gtest/gtest.h>

#include <regex>

namespace slosh
{
namespace
{

namespace fs = std::filesystem;

class PublicReports : public testing::Test
{
protected:
    CaseDirectory case_;

    /// The number behind `what` in a log.
    static double numberAfter(const std::string& what, const std::string& log)
    {
        std::smatch found;
        const bool isThere = std::regex_search(log, found, std::regex(what + R"([ :=]*([-0-9.e+]+))"));
        EXPECT_TRUE(isThere) << what << " is not in: " << log;
        return isThere ? std::stod(found[1]) : 0;
    }
    static std::string warningsIn(const std::string& log)
    {
        std::string warnings;
        const std::regex line("--> FOAM Warning[^\n]*\n");
        for (std::sregex_iterator warning(log.begin(), log.end(), line), end; warning != end; ++warning)
        {
            warnings += warning->str();
        }
        return warnings;
    }
    void move(const std::string& function, const std::string& coeffs)
    {
        case_.write(
            "constant/dynamicMeshDict",
            "solidBodyMotionFunction " + function + ";\n" + function + "Coeffs { " + coeffs + " }\n"
        );
    }
};

// emefff/Sloshing-In-Fuel-Tank-Around-F1-Circuit-With-OpenFOAM, DualSPHysics#74
TEST_F(PublicReports, ATankThatTravelsHasTheSpeedOfSoundOfOneAtRest)
{
    move("linearMotion", "velocity (0 20 0);");
    case_.edit("system/blockParticlesDict", "particleSpacing", "liquidAtRest tankFrame; particleSpacing");
    EXPECT_NEAR(numberAfter("Speed of sound", case_.succeed("blockParticles")), 9.9045, 1e-3); // 10 sqrt(g 0.1 m)
    const std::string log = case_.succeed("sloshSPHFoam");
    EXPECT_NEAR(numberAfter("Speed of sound", log), 9.9045, 1e-3);
    EXPECT_EQ(warningsIn(log), "");
    case_.edit("system/blockParticlesDict", "tankFrame", "inertialFrame"); // it sets off with 20 m/s
    EXPECT_NEAR(numberAfter("Speed of sound", case_.succeed("blockParticles")), 209.9, 0.1);
}

// A time directory that was copied to another name
TEST_F(PublicReports, ATimeDirectoryStandsForTheTimeOfItsName)
{
    case_.succeed("blockParticles");
    case_.succeed("sloshSPHFoam");
    fs::remove_all(case_.path() / "0");
    fs::remove_all(case_.path() / "0.05");
    fs::remove_all(case_.path() / "postProcessing");
    fs::rename(case_.path() / "0.1", case_.path() / "0");
    case_.edit("system/controlDict", "endTime 0.1", "endTime 0.05");
    const std::string log = case_.succeed("sloshSPHFoam");
    EXPECT_NE(log.find("Start from 0,"), std::string::npos) << log;
    EXPECT_NE(warningsIn(log).find("0/uniform/time: value is 0.1"), std::string::npos) << warningsIn(log);
    EXPECT_NE(warningsIn(log).find("the tank jumps"), std::string::npos) << "it was elsewhere at 0.1 s";
    EXPECT_TRUE(fs::exists(case_.path() / "0.05/lagrangian"));
    EXPECT_GT(numberAfter("Steps", log), 10);
}

// A motion that was changed before a restart
TEST_F(PublicReports, ATankThatJumpsAtARestartIsWarnedOf)
{
    move("oscillatingLinearMotion", "amplitude (0 0.03 0); omega 5;");
    case_.succeed("blockParticles");
    EXPECT_EQ(warningsIn(case_.succeed("sloshSPHFoam")), "");
    case_.edit("system/controlDict", "endTime 0.1", "endTime 0.11");
    EXPECT_EQ(warningsIn(case_.succeed("sloshSPHFoam")), "") << "nothing was changed";
    case_.edit("constant/dynamicMeshDict", "0.03", "0.06");
    case_.edit("system/controlDict", "endTime 0.11", "endTime 0.12");
    const std::string warnings = warningsIn(case_.succeed("sloshSPHFoam"));
    EXPECT_NE(warnings.find("constant/dynamicMeshDict: the tank jumps at 0.1 s"), std::string::npos) << warnings;
    // 0.1 m + 0.06 m sin(0.5), and with 0.03 m; 0.3 m/s cos(0.5), and half of it.
    EXPECT_NE(warnings.find("0.128766"), std::string::npos) << warnings;
    EXPECT_NE(warnings.find("0.114383"), std::string::npos) << warnings;
    EXPECT_NE(warnings.find("0.263275"), std::string::npos) << warnings;
    EXPECT_NE(warnings.find("0.131637"), std::string::npos) << warnings;
}

// gerlero/foamlib#392, PyFoam#1
TEST_F(PublicReports, TheCaseIsKnownInAFileThatLiesInItAndUnitsHaveSymbols)
{
    case_.write("simControls", "endTime 0.05;\n#include \"$FOAM_CASE/controls/writing\"\n");
    case_.write("controls/writing", "writeInterval 0.025;\n");
    case_.edit("system/controlDict", "writePrecision 10;", "writePrecision 10;\n#include \"$FOAM_CASE/simControls\"");
    case_.edit("constant/g", "[0 1 -2 0 0 0 0]", "[m s^-2]");
    case_.edit("constant/fluidProperties", "[1 -3 0 0 0 0 0]", "[kg m^-3]");
    case_.succeed("blockParticles");
    case_.succeed("sloshSPHFoam");
    EXPECT_TRUE(fs::exists(case_.path() / "0.025/lagrangian"));
    EXPECT_TRUE(fs::exists(case_.path() / "0.05/lagrangian"));
    EXPECT_FALSE(fs::exists(case_.path() / "0.1"));
}

// A blockMeshDict with C's constants, solids4foam's motion
TEST_F(PublicReports, ExpressionsOfPresentOpenFOAMAreRead)
{
    case_.edit("constant/tankProperties", "fillDepth 0.1;", "fillDepth #calc \"0.1*cos(M_PI/4.0)\";");
    move(
        "oscillatingLinearMotion",
        "h 0.0125; amplitude (0 -$h 0); omega ${{ 2*pi() }}; phaseShift 0.25; verticalShift (0 $h 0);"
    );
    EXPECT_NEAR(numberAfter("liquid depth", case_.succeed("blockParticles")), 0.0707107, 1e-6);
    case_.succeed("sloshSPHFoam");
    EXPECT_TRUE(std::regex_search(case_.text("0/uniform/tankState"), std::regex(R"(
c +\(0 0 0\);)"))
    ) << case_.text("0/uniform/tankState");
}

// DualSPHysics and OpenFOAM run over MPI.
TEST_F(PublicReports, AParallelRunIsToldOfThreads)
{
    const Ended ended = case_.run("sloshSPHFoam -parallel");
    EXPECT_EQ(ended.status, 1);
    EXPECT_NE(ended.err.find("-threads <n>"), std::string::npos) << ended.err;
}

} // namespace
} // namespace slosh
