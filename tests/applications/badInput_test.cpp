// SPDX-License-Identifier: GPL-3.0-or-later
// What a user can get wrong: each a message with place and remedy, exit status 1, and a case left as it was.
#include "badInput.hpp"
#include "programNames.hpp"

#include <gtest/gtest.h>

namespace slosh
{
namespace
{

namespace fs = std::filesystem;

// Command line

TEST_F(BadInput, UnknownOptionIsNamedWithTheNearestByEveryProgram)
{
    for (const std::string& program : programNames())
    {
        expectRefused(
            case_, program + " -bogus",
            {"--> FOAM FATAL ERROR:\nInvalid option: -bogus", "See '" + program + " -help' for usage"}
        );
        expectRefused(case_, program + " -csae .", {"Invalid option: -csae; did you mean -case?"});
    }
}

TEST_F(BadInput, ArgumentThatIsNoOptionIsRefused)
{
    expectRefused(case_, "sloshSPHFoam someCase", {"Invalid argument", "takes options only"});
}

TEST_F(BadInput, NumberOfThreadsMustBeWholeAndPositive)
{
    for (const std::string threads : {"0", "-1", "two", "1.5", "2x"})
    {
        expectRefused(case_, "sloshSPHFoam -threads " + threads, {threads});
        expectRefused(case_, "sloshSPHFoam", {"OMP_NUM_THREADS is " + threads}, "OMP_NUM_THREADS=" + threads);
    }
    EXPECT_EQ(case_.run("sloshSPHFoam -help", "OMP_NUM_THREADS=two").status, 0);
    EXPECT_EQ(case_.run("sloshSPHFoam -dry-run -threads 1", "OMP_NUM_THREADS=two").status, 1) << "no particles yet";
}

TEST_F(BadInput, HelpIsNoError)
{
    for (const std::string& program : programNames())
    {
        EXPECT_NE(case_.succeed(program + " -help").find("Usage: " + program), std::string::npos);
    }
}

// Missing things

TEST_F(BadInput, MissingCaseDirectoryIsNamed)
{
    for (const std::string& program : programNames())
    {
        expectRefused(case_, program + " -case absent", {"cannot open case directory \"absent\""});
    }
}

TEST_F(BadInput, DirectoryThatIsNoCaseIsRefused)
{
    case_.remove("system");
    expectRefused(case_, "blockParticles", {"cannot open case directory", "constant and system"});
}

TEST_F(BadInput, MissingFileIsNamed)
{
    for (const std::string file :
         {"constant/tankProperties", "constant/fluidProperties", "constant/g", "system/blockParticlesDict"})
    {
        const CaseDirectory theCase;
        theCase.remove(file);
        expectRefused(theCase, "blockParticles", {"FOAM FATAL IO ERROR", file});
    }
}

TEST_F(BadInput, MissingKeyIsNamedWithItsFileAndLines)
{
    case_.edit("constant/tankProperties", "min (-0.5 -0.1 0);", "");
    expectRefused(
        case_, "blockParticles", {"entry 'min' not found in dictionary \"constant/tankProperties\"", "(lines 1 to "}
    );
}

TEST_F(BadInput, MisspeltKeyIsNamedWithTheNearestValidOne)
{
    case_.edit("constant/tankProperties", "fillDepth", "filDepth");
    expectRefused(case_, "blockParticles", {"fillDepth", "filDepth", "constant/tankProperties:5"});
}

TEST_F(BadInput, UnknownWordIsAnsweredWithTheValidOnes)
{
    case_.edit("constant/kernelProperties", "improvedGaussian", "gausian");
    expectRefused(
        case_, "blockParticles",
        {"constant/kernelProperties:2: unknown kernel", "'gausian'",
         "cubicSpline improvedGaussian quinticSpline taperedGaussian wendlandC2"}
    );
}

TEST_F(BadInput, DictionaryThatDoesNotEndIsRefused)
{
    case_.edit("constant/fluidProperties", "0.03; }", "0.03;");
    expectRefused(case_, "blockParticles", {"constant/fluidProperties:3: the "});
}

// Wrong values

TEST_F(BadInput, WrongUnitIsShownBesideTheRightOne)
{
    case_.edit("constant/fluidProperties", "[1 -3 0 0 0 0 0]", "[0 2 -1 0 0 0 0]");
    expectRefused(
        case_, "blockParticles",
        {"rho0 has the dimensions [0 2 -1 0 0 0 0]", "expected [1 -3 0 0 0 0 0] (kg/m^3)",
         "constant/fluidProperties:2: rho0"}
    );
}

TEST_F(BadInput, GravityMustHaveItsDimensions)
{
    case_.edit("constant/g", "[0 1 -2 0 0 0 0]", "[0 1 -1 0 0 0 0]");
    expectRefused(case_, "blockParticles", {"dimensions", "[0 1 -2 0 0 0 0] (m/s^2)", "constant/g:2"});
}

TEST_F(BadInput, DimensionsHaveSevenExponents)
{
    case_.edit("constant/fluidProperties", "[1 -3 0 0 0 0 0]", "[1 -3 0]");
    expectRefused(case_, "blockParticles", {"rho0 has the dimensions [1 -3 0]", "7"});
}

TEST_F(BadInput, WrongSignIsRefusedInTheDocumentedWords)
{
    case_.edit("constant/fluidProperties", "1000", "-998");
    expectRefused(
        case_, "blockParticles",
        {"--> FOAM FATAL IO ERROR:\nconstant/fluidProperties:2: rho0 is -998; expected a number > 0 [kg/m^3]"}
    );
}

TEST_F(BadInput, WordInPlaceOfANumberIsRefused)
{
    case_.edit("constant/fluidProperties", "1000", "heavy");
    expectRefused(case_, "blockParticles", {"rho0 is heavy", "a number > 0"});
}

TEST_F(BadInput, VectorOfTwoComponentsIsRefused)
{
    case_.edit("constant/tankProperties", "(0.5 0.1 0.15)", "(0.1 0.15)");
    expectRefused(case_, "blockParticles", {"max is (0.1 0.15)", "constant/tankProperties:4"});
}

TEST_F(BadInput, SpacingMustBePositiveFiniteAndSmallerThanTheTank)
{
    for (const std::string spacing : {"0", "-0.01", "nan", "inf", "1e-400", "0.5", "1e9"})
    {
        const CaseDirectory theCase;
        theCase.edit("system/blockParticlesDict", "particleSpacing 0.01", "particleSpacing " + spacing);
        expectRefused(theCase, "blockParticles", {"particleSpacing", "system/blockParticlesDict"});
    }
}

TEST_F(BadInput, SpacingThatNoMachineCouldHoldIsRefusedAtOnce)
{
    case_.edit("system/blockParticlesDict", "particleSpacing 0.01", "particleSpacing 1e-9");
    expectRefused(case_, "blockParticles", {"particleSpacing", "at most 1e9"});
}

TEST_F(BadInput, FillAboveTheRoofIsRefusedHoweverItIsGiven)
{
    for (const auto& [fill, most] :
         {std::pair("fillDepth 0.2", "0.15"), {"fillLevel 0.2", "0.15"}, {"fillVolume 0.05", "0.03 m^3"}})
    {
        const CaseDirectory theCase;
        theCase.edit("constant/tankProperties", "fillDepth 0.1", fill);
        expectRefused(theCase, "blockParticles", {"fill", "constant/tankProperties:5", most});
    }
}

TEST_F(BadInput, TwoFillsAreRefused)
{
    case_.edit("constant/tankProperties", "fillDepth 0.1;", "fillDepth 0.1; fillLevel 0.1;");
    expectRefused(case_, "blockParticles", {"fillDepth", "fillLevel"});
}

TEST_F(BadInput, ThinBaffleIsRefusedWithTheSpacingItNeeds)
{
    case_.edit("constant/tankProperties", "fillDepth 0.1;", R"(fillDepth 0.1;
geometry { baffle { type searchableBox; min (-0.5 -0.00369 0); max (0.5 0.00369 0.05); } })");
    // Support 3 x 1.23 dx; 0.00738/3.69 = 0.002.
    expectRefused(case_, "blockParticles", {"baffle", "0.00738", "0.0369", "at most 0.002 m"});
}

TEST_F(BadInput, TooFewWallLayersForTheKernelAreRefused)
{
    case_.edit("system/blockParticlesDict", "particleSpacing", "wallLayers 2; particleSpacing");
    expectRefused(case_, "blockParticles", {"wallLayers is 2", "at least 4"});
}

TEST_F(BadInput, RepeatedRunOfBlockParticlesThatFailsKeepsTheOldParticles)
{
    case_.succeed("blockParticles");
    case_.edit("system/blockParticlesDict", "particleSpacing 0.01", "particleSpacing -1");
    expectRefused(case_, "blockParticles", {"particleSpacing is -1"});
}

// The solver's dictionaries

TEST_F(BadInput, SolverWithoutParticlesNamesTheProgramThatMakesThem)
{
    expectRefused(case_, "sloshSPHFoam", {"no time directory", "run blockParticles first"});
}

TEST_F(BadInputOfSolver, UnknownKeyOfControlDictIsRefused)
{
    case_.edit("system/controlDict", "writeInterval 0.05", "writeIntervall 0.05");
    expectRefused(case_, "sloshSPHFoam", {"writeInterval", "system/controlDict"});
}

TEST_F(BadInputOfSolver, EndBeforeTheStartIsRefused)
{
    case_.edit("system/controlDict", "endTime 0.1", "endTime -1");
    expectRefused(case_, "sloshSPHFoam", {"endTime is -1", "system/controlDict:4"});
}

TEST_F(BadInputOfSolver, StartTimeThatIsNotThereIsAnsweredWithThoseThatAre)
{
    case_.edit("system/controlDict", "startFrom latestTime", "startFrom startTime; startTime 3");
    expectRefused(case_, "sloshSPHFoam", {"startTime is 3", "expected one of 0"});
}

TEST_F(BadInputOfSolver, ProbeOutsideTheTankIsRefusedWithTheTanksCorners)
{
    case_.edit("system/controlDict", "(0 0.1 0.14)", "(0 0.2 0.14)");
    expectRefused(case_, "sloshSPHFoam", {"probeLocations", "0.2", "outside the tank", "system/controlDict:"});
}

TEST_F(BadInputOfSolver, UnknownFunctionTypeIsRefused)
{
    case_.edit("system/controlDict", "type probes", "type probe");
    expectRefused(case_, "sloshSPHFoam", {"unknown function type 'probe'", "did you mean 'probes'?"});
}

TEST_F(BadInputOfSolver, UnknownMotionIsRefusedWithTheNearest)
{
    case_.edit(
        "constant/dynamicMeshDict", "solidBodyMotionFunction oscillatingRotatingMotion",
        "solidBodyMotionFunction oscilatingRotatingMotion"
    );
    expectRefused(case_, "sloshSPHFoam", {"'oscilatingRotatingMotion'", "did you mean 'oscillatingRotatingMotion'?"});
}

TEST_F(BadInputOfSolver, MisspeltEntryBesideTheNameOfItsMotionIsRefusedWithTheNearest)
{
    case_.write(
        "constant/dynamicMeshDict",
        "solidBodyMotionFunction oscillatingLinearMotion;\namplitude (0.01 0 0); omega 4;\nphaseShfit 0.3;\n"
    );
    expectRefused(case_, "sloshSPHFoam", {"constant/dynamicMeshDict:3: unknown keyword 'phaseShfit'", "'phaseShift'?"});
}

TEST_F(BadInputOfSolver, CellZoneThatMovesAloneIsRefused)
{
    case_.write(
        "constant/dynamicMeshDict",
        "solidBodyCoeffs\n{\n    cellZone rotor;\n    solidBodyMotionFunction linearMotion; velocity (0.1 0 0);\n}\n"
    );
    expectRefused(
        case_, "sloshSPHFoam",
        {"constant/dynamicMeshDict:3: cellZone is rotor", "the tank moves as a whole", "expected no such entry"}
    );
}

class BadMotionTable : public BadInputOfSolver
{
protected:
    void SetUp() override
    {
        BadInputOfSolver::SetUp();
        case_.write(
            "constant/dynamicMeshDict", "solidBodyMotionFunction tabulated6DoFMotion;\n"
                                        "tabulated6DoFMotionCoeffs { CofG (0 0 0); timeDataFileName "
                                        "\"constant/6DoF.dat\"; }\n"
        );
    }
};

TEST_F(BadMotionTable, ThatIsMissingIsNamed)
{
    expectRefused(case_, "sloshSPHFoam", {"constant/6DoF.dat: cannot read the motion table"});
}

TEST_F(BadMotionTable, ThatIsADirectoryIsNamed)
{
    fs::create_directory(case_.path() / "constant/6DoF.dat");
    expectRefused(case_, "sloshSPHFoam", {"constant/6DoF.dat: cannot read the motion table"});
}

TEST_F(BadMotionTable, ThatHoldsNonsenseIsRefusedWithItsLineAndFormat)
{
    case_.write("constant/6DoF.dat", "2\n(\n(0 ((0 0 0) (0 0 0)))\n(1 ((0 0 0) (0 zero 0)))\n)\n");
    expectRefused(case_, "sloshSPHFoam", {"constant/6DoF.dat:4", "(t ((x y z) (a b c)))"});
    case_.write("constant/6DoF.dat", "3\n(\n(0 ((0 0 0) (0 0 0)))\n(1 ((0 0 0) (0 0 0)))\n)\n");
    expectRefused(case_, "sloshSPHFoam", {"declares 3 rows and has 2"});
    case_.write("constant/6DoF.dat", "2\n(\n(1 ((0 0 0) (0 0 0)))\n(0 ((0 0 0) (0 0 0)))\n)\n");
    expectRefused(case_, "sloshSPHFoam", {"does not increase in time", ":4: "});
    case_.write("constant/6DoF.dat", "2\n(\n(0 ((0 0 0) (0 0 0)))\n");
    expectRefused(case_, "sloshSPHFoam", {"constant/6DoF.dat"});
}

TEST_F(BadMotionTable, ThatEndsBeforeTheRunIsRefusedBeforeTheRun)
{
    case_.write("constant/6DoF.dat", "2\n(\n(0 ((0 0 0) (0 0 0)))\n(0.05 ((0 0 0) (0 0 0)))\n)\n");
    expectRefused(case_, "sloshSPHFoam", {"endTime is 0.1", "expected at most 0.05 s", "system/controlDict:4"});
}

TEST_F(BadMotionTable, ThatBeginsAfterTheRunIsRefused)
{
    case_.write("constant/6DoF.dat", "2\n(\n(0.01 ((0 0 0) (0 0 0)))\n(1 ((0 0 0) (0 0 0)))\n)\n");
    expectRefused(case_, "sloshSPHFoam", {"covers 0.01 to 1 s"});
}

// The start

TEST_F(BadInput, ConditionAtWallsThatDoesNotExistIsRefused)
{
    const std::string fluid = case_.text("constant/fluidProperties");
    case_.write("constant/fluidProperties", fluid + "viscosity { type laminar; nu 1e-3; walls slippy; }\n");
    expectRefused(case_, "blockParticles", {"unknown wall condition 'slippy'", "did you mean 'slip'?", "noSlip slip"});
}

TEST_F(BadInput, InitialFieldsThatAreNoFormulasAreRefused)
{
    const std::string dict = case_.text("system/blockParticlesDict");
    case_.write("system/blockParticlesDict", dict + "initialFields { p \"2*depth\"; }\n");
    expectRefused(case_, "blockParticles", {"2*depth", "unknown name 'depth'", "formula in x, y and z"});
    case_.write(
        "system/blockParticlesDict", dict + "initialFields { U (\"0\" \"0\" \"0\"); }\nliquidAtRest tankFrame;\n"
    );
    expectRefused(case_, "blockParticles", {"liquidAtRest and U of initialFields are both set"});
    case_.write("system/blockParticlesDict", dict + "initialFields { p \"0\"; }\nsettle { time 0.1; }\n");
    expectRefused(case_, "blockParticles", {"settle needs gravity and walls"});
}

} // namespace
} // namespace slosh
