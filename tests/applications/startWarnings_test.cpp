// SPDX-License-Identifier: GPL-3.0-or-later
// What sloshSPHFoam says of a case before its first step: warnings, steps that it refuses.
#include "CaseDirectory.hpp"

#include <gtest/gtest.h>

#include <sstream>

namespace slosh
{
namespace
{

class StartWarnings : public testing::Test
{
protected:
    CaseDirectory case_;
};

/// The warnings of a dry run.
std::string warningsOf(const CaseDirectory& theCase)
{
    std::istringstream log(theCase.succeed("sloshSPHFoam -dry-run"));
    std::string warnings;
    for (std::string line; std::getline(log, line);)
    {
        warnings += line.find("--> FOAM Warning") == 0 ? line + "\n" : "";
    }
    return warnings;
}

TEST_F(StartWarnings, WarnsOfASpeedOfSoundFarTooLow)
{
    // sqrt(g 0.1 m) + the corners' speed = 1.15 m/s: five times that is 5.74 m/s.
    case_.succeed("blockParticles");
    EXPECT_EQ(warningsOf(case_), "");
    case_.edit("constant/fluidProperties", "viscosity", "equationOfState { speedOfSound 5.5; } viscosity");
    EXPECT_NE(warningsOf(case_).find("constant/fluidProperties: speedOfSound is 5.5 m/s, "), std::string::npos);
    case_.edit("constant/fluidProperties", "speedOfSound 5.5", "speedOfSound 6");
    EXPECT_EQ(warningsOf(case_), "");
}

TEST_F(StartWarnings, TakesAShorterStepWhereTheSpeedOfSoundIsFarTooHigh)
{
    // Ten times 'auto' is 114.8 m/s.
    case_.write("constant/fluidProperties", "rho0 998; equationOfState { speedOfSound 116; }\n");
    case_.write("system/sphSchemes", "scheme recommended;\n");
    case_.succeed("blockParticles");
    const std::string warnings = warningsOf(case_);
    EXPECT_NE(warnings.find("constant/fluidProperties: speedOfSound is 116 m/s, 101."), std::string::npos) << warnings;
    EXPECT_NE(warnings.find("maxCo is 0.792016, reduced to that"), std::string::npos) << warnings;
    EXPECT_NE(case_.succeed("sloshSPHFoam -dry-run").find(" s (maxCo 0.792016)"), std::string::npos);
    case_.edit("system/controlDict", "adjustTimeStep yes", "adjustTimeStep yes; maxCo 0.8");
    EXPECT_NE(warningsOf(case_).find("maxCo is 0.8 (system/controlDict:"), std::string::npos);
    case_.edit("system/controlDict", "maxCo 0.8", "maxCo 0.79");
    EXPECT_EQ(warningsOf(case_), "");
    case_.edit("system/controlDict", "maxCo 0.79", "maxCo 0.8");
    case_.edit("constant/fluidProperties", "116", "114");
    EXPECT_EQ(warningsOf(case_), "");
}

TEST_F(StartWarnings, WarnsOfAStepBeyondTheLimitOfStability)
{
    case_.succeed("blockParticles");
    case_.edit("system/controlDict", "adjustTimeStep yes", "adjustTimeStep yes; maxCo 0.7");
    EXPECT_NE(
        warningsOf(case_).find("system/controlDict:6: maxCo is 0.7, above the stability limit"), std::string::npos
    );
    // c0 = 20 m/s, h = 0.0123 m: 0.65 h/c0 = 4.0e-4 s.
    case_.edit("constant/fluidProperties", "viscosity", "equationOfState { speedOfSound 20; } viscosity");
    case_.edit("system/controlDict", "adjustTimeStep yes; maxCo 0.7", "adjustTimeStep no");
    case_.edit("system/controlDict", "deltaT 1e-4", "deltaT 3.9e-4");
    EXPECT_EQ(warningsOf(case_), "");
    case_.edit("system/controlDict", "deltaT 3.9e-4", "deltaT 4.1e-4");
    EXPECT_NE(
        warningsOf(case_).find("system/controlDict:5: deltaT is 0.00041 s, above the stability limit"),
        std::string::npos
    );
}

TEST_F(StartWarnings, RefusesAStepThatIsStableWithNoKernel)
{
    case_.succeed("blockParticles");
    case_.edit("system/controlDict", "adjustTimeStep yes", "adjustTimeStep yes; maxCo 0.94");
    case_.succeed("sloshSPHFoam -dry-run");
    case_.edit("system/controlDict", "maxCo 0.94", "maxCo 0.95");
    EXPECT_NE(
        case_.run("sloshSPHFoam")
            .err.find("system/controlDict:6: maxCo is 0.95; expected at most 0.944, limits courantNumber of "
                      "system/sphSchemes "
                      "(docs/stability.md)"),
        std::string::npos
    );
    case_.edit("system/sphSchemes", "scheme", "limits { courantNumber 0.95; } scheme");
    case_.succeed("sloshSPHFoam -dry-run");
    // c0 = 20 m/s, h = 0.0123 m: 0.95 h/c0 = 5.843e-4 s.
    case_.edit("constant/fluidProperties", "viscosity", "equationOfState { speedOfSound 20; } viscosity");
    case_.edit("system/controlDict", "adjustTimeStep yes; maxCo 0.95", "adjustTimeStep no");
    case_.edit("system/controlDict", "deltaT 1e-4", "deltaT 5.84e-4");
    case_.succeed("sloshSPHFoam -dry-run");
    case_.edit("system/controlDict", "deltaT 5.84e-4", "deltaT 5.85e-4");
    EXPECT_NE(
        case_.run("sloshSPHFoam").err.find("deltaT is 0.000585 s; expected at most 0.00058425 s, 0.95 h/c0, "),
        std::string::npos
    );
    EXPECT_FALSE(std::filesystem::exists(case_.path() / "postProcessing"));
}

} // namespace
} // namespace slosh
