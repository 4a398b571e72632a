// SPDX-License-Identifier: GPL-3.0-or-later
// foamToSlosh on cases as foam-extend and the versions of OpenFOAM have them, and what it tells of them.
#include "InterFoamBox.hpp"

#include "dictionary/Dictionary.hpp"

#include <gtest/gtest.h>

namespace slosh
{
namespace
{

namespace fs = std::filesystem;

class FoamDialect : public testing::Test
{
protected:
    Dictionary ours(const std::string& file) const { return Dictionary::read(case_.path() / "ours" / file, file); }

    InterFoamBox case_;
};

TEST_F(FoamDialect, ReadsZonesOfSetFields)
{
    case_.write(
        "system/setFieldsDict",
        "defaultValues { alpha.water 0; }\nzones\n{\n    inside { type box; zoneType cell; box (-9 -9 -9) (9 9 0.3);\n"
        "        values { alpha.water 1; U (1 0 0); } }\n}\n"
    );
    expectHas(
        case_.converted(), {"0.3 m deep, 0.6 m^3", "Dialect   : OpenFOAM 10 or later (zones in system/setFieldsDict)",
                            "system/setFieldsDict:5: U is not used; the liquid starts at rest"}
    );
    EXPECT_EQ(ours("constant/tankProperties").scalar("fillLevel", unit::metre), 0.3);

    case_.edit("system/setFieldsDict", "type box", "type cylinder");
    expectHas(
        case_.refused().err, {"system/setFieldsDict:4: the zone 'inside' is of type cylinder; expected box",
                              "\nThe case is written for OpenFOAM 10 or later (zones in system/setFieldsDict)."}
    );
}

TEST_F(FoamDialect, ReadsPhysicalPropertiesOfEachPhase)
{
    case_.remove("constant/transportProperties");
    case_.write("constant/phaseProperties", "phases (water air);\nsigma 0.07;\npMin 1;\n");
    case_.write("constant/physicalProperties.water", "viscosityModel constant;\nnu [m^2/s] 2e-06;\nrho 998.2;\n");
    case_.write("constant/physicalProperties.air", "viscosityModel constant; nu 1.48e-05; rho 1;\n");
    expectHas(
        case_.converted(),
        {"rho0 998.2 kg/m^3, nu 2e-06 m^2/s", "Dialect   : OpenFOAM 10 or later (constant/phaseProperties)",
         "constant/phaseProperties:2: sigma is not 0; surface tension is not computed",
         "constant/phaseProperties:3: pMin is not used"}
    );
    case_.remove("constant/physicalProperties.water");
    expectHas(case_.refused().err, {"constant/physicalProperties.water: file not found"});
    case_.remove("constant/phaseProperties");
    expectHas(
        case_.refused().err,
        {"constant/transportProperties: file not found; expected it, or constant/phaseProperties (OpenFOAM 10"}
    );
}

TEST_F(FoamDialect, ReadsMoverAndTheFileOfFunctions)
{
    const std::string mover = "mover { type motionSolver; libs (\"libfvMotionSolvers.so\"); motionSolver solidBody;\n"
                              "solidBodyMotionFunction oscillatingLinearMotion; amplitude (0.01 0 0); omega 4; }\n";
    case_.write("constant/dynamicMeshDict", mover);
    case_.write(
        "system/functions",
        "low { type probes; fields (p); probeLocations ((0 0 0.1)); writeControl timeStep; writeInterval 1; }\n"
        "#includeFunc residuals\n"
    );
    expectHas(
        case_.converted(),
        {"Motion    : oscillatingLinearMotion: amplitude (0.01 0 0) m, omega 4 rad/s", "Functions : 1\n",
         "system/functions:2: the function 'residuals' is of type residuals; it is omitted",
         "Dialect   : OpenFOAM 10 or later (system/functions)"}
    );
    EXPECT_EQ(case_.text("ours/constant/dynamicMeshDict"), mover);
    EXPECT_EQ(ours("system/probesDict").dict("low").scalar("writeInterval", unit::second), 0.001);
    case_.edit("ours/system/controlDict", "endTime         1;", "endTime         0.002;");
    case_.succeed("blockParticles -case ours");
    const std::string log = case_.succeed("sloshSPHFoam -case ours");
    EXPECT_EQ(log.find("Not used"), std::string::npos) << log;
}

TEST_F(FoamDialect, KeepsAMotionWhoseDictionaryIsCompressed)
{
    case_.write("constant/dynamicMeshDict", "solidBodyMotionFunction linearMotion; velocity (1 0 0);\n");
    ASSERT_EQ(std::system(("gzip '" + (case_.path() / "constant/dynamicMeshDict").string() + "'").c_str()), 0);
    expectHas(case_.converted(), {"Motion    : linearMotion: velocity (1 0 0) m/s"});
    case_.succeed("blockParticles -case ours");
    expectHas(case_.succeed("sloshSPHFoam -case ours -dry-run"), {"Motion: linearMotion: velocity (1 0 0) m/s"});
}

TEST_F(FoamDialect, KeepsCoefficientsOfAnotherMotionAndTellsThatTheyAreNotUsed)
{
    case_.write(
        "constant/dynamicMeshDict",
        "motionSolver solidBody; motionSolverLibs (fvMotionSolvers); solidBodyMotionFunction linearMotion;\n"
        "linearMotionCoeffs { velocity (0.1 0 0); }\n"
        "rotatingMotionCoeffs { origin (0 0 0); axis (0 0 1); omega 3; }\n"
    );
    const std::string notUsed = "constant/dynamicMeshDict:3: rotatingMotionCoeffs";
    expectHas(case_.converted(), {"Warning: " + notUsed + " is not used\n"});
    case_.succeed("blockParticles -case ours");
    const std::string log = case_.succeed("sloshSPHFoam -case ours -dry-run");
    expectHas(log, {"Not used: " + notUsed + "\n"});
    EXPECT_EQ(log.find("motionSolverLibs"), std::string::npos) << log;
}

TEST_F(FoamDialect, ReadsPhase1AndAlpha1)
{
    case_.edit("system/setFieldsDict", "alpha.water 0", "alpha1 0");
    case_.edit("system/setFieldsDict", "alpha.water 1", "alpha1 1");
    expectHas(
        case_.converted(), {"rho0 1000 kg/m^3", "the gas 'air', ",
                            "Dialect   : foam-extend, or OpenFOAM before 2.3 (alpha1 in system/setFieldsDict)\n"}
    );
    case_.write(
        "constant/transportProperties",
        "phase1 { transportModel Newtonian; nu nu [0 2 -1 0 0 0 0] 1e-06; rho rho [1 -3 0 0 0 0 0] 1025;\n"
        "    CrossPowerLawCoeffs { nu0 nu0 [0 2 -1 0 0 0 0] 1e-06; } }\n"
        "phase2 { transportModel Newtonian; nu 1.48e-05; rho 1; }\nsigma sigma [1 0 -2 0 0 0 0] 0;\n"
    );
    const std::string dialect = "foam-extend, or OpenFOAM before 2.3 (phase1 in constant/transportProperties)";
    const std::string log = case_.converted();
    expectHas(log, {"rho0 1025 kg/m^3", "the gas 'phase2', ", "Dialect   : " + dialect});
    EXPECT_EQ(log.find("CrossPowerLaw"), std::string::npos) << log;

    // The same where the volume fraction has its later name.
    case_.edit("system/setFieldsDict", "alpha1 0", "alpha.phase1 0");
    case_.edit("system/setFieldsDict", "alpha1 1", "alpha.phase1 1");
    expectHas(case_.converted(), {"rho0 1025 kg/m^3"});

    // What cannot be converted is named, with the dialect, and nothing that is not so is said.
    case_.edit("system/setFieldsDict", "alpha.phase1 1", "alpha.water 1");
    case_.edit("system/setFieldsDict", "alpha.phase1 0", "alpha.water 0");
    const std::string refusal = case_.refused().err;
    expectHas(
        refusal, {"constant/transportProperties:1: phase1 is the liquid", "sets alpha.water; expected alpha1 there",
                  "The case is written for foam-extend, or OpenFOAM before 2.3 (phase1 in constant/transport"}
    );
    EXPECT_EQ(refusal.find("meant"), std::string::npos) << refusal;
    case_.edit("constant/transportProperties", "phase1 {", "liquid {");
    expectHas(case_.refused().err, {"constant/transportProperties: no phases found; expected `phases (water air);`"});
    case_.edit("system/controlDict", "application", "/* foam-extend: Open Source CFD */ application");
    expectHas(case_.refused().err, {"The case is written for foam-extend (system/controlDict)."});
}

TEST_F(FoamDialect, SaysWhereAFieldIsMissingHowItIsCalled)
{
    case_.edit("system/setFieldsDict", "alpha.water 0", "gamma 0");
    case_.edit("system/setFieldsDict", "alpha.water 1", "gamma 1");
    const Ended ended = case_.refused();
    expectHas(ended.err, {"system/setFieldsDict: no volume fraction is set; expected alpha.<phase>, or alpha1"});
    expectHas(ended.out, {"--> FOAM Warning: system/setFieldsDict:1: gamma is not used"});
}

TEST_F(FoamDialect, NamesEntriesOfTransportPropertiesThatAreLeftOut)
{
    case_.write(
        "constant/transportProperties",
        "nuWater 1e-06;\n" + case_.text("constant/transportProperties") +
            "period period [0 0 1 0 0 0 0] 0.17;\namplitude amplitude [0 1 0 0 0 0 0] 0.005;\n"
    );
    case_.edit("constant/transportProperties", "nu 1e-06;", "nu $nuWater;");
    const std::string log = case_.converted();
    expectHas(
        log,
        {"constant/transportProperties:6: period is not used", "constant/transportProperties:7: amplitude is not used"}
    );
    EXPECT_EQ(log.find("nuWater"), std::string::npos) << log;
}

TEST_F(FoamDialect, PrintsTheWarningsFoundBeforeAnError)
{
    case_.write("constant/fvOptions", "limit { type limitVelocity; active yes; }\noff { type x; active no; }\n");
    case_.write("constant/momentumTransport", "simulationType RAS;\n");
    case_.edit("constant/g", "(0 0 -9.81)", "(0 -9 -9)");
    const Ended ended = case_.refused();
    expectHas(
        ended.out, {"Warning: constant/fvOptions:1: 'limit' (limitVelocity) is not used\n",
                    "Warning: constant/momentumTransport:1: simulationType is RAS; turbulence is not modelled"}
    );
    EXPECT_EQ(ended.out.find("'off'"), std::string::npos) << ended.out;
    expectHas(ended.err, {"constant/g:1: gravity is not along an axis"});
}

TEST_F(FoamDialect, RefusesWhatDrivesTheLiquidByAnAcceleration)
{
    for (const std::string file : {"constant/fvOptions", "system/fvOptions", "constant/fvModels"})
    {
        case_.write(
            file, "\nshaking { type tabulatedAccelerationSource; active true;\n"
                  "tabulatedAccelerationSourceCoeffs { timeDataFileName \"constant/a.dat\"; } }\n"
        );
        expectHas(
            case_.refused().err, {file + ":2: 'shaking' (tabulatedAccelerationSource) accelerates the liquid",
                                  "constant/dynamicMeshDict", "`active no;`"}
        );
        case_.edit(file, "active true", "active no");
        const std::string log = case_.converted();
        EXPECT_EQ(log.find("shaking"), std::string::npos) << log;
        case_.remove(file);
    }
    case_.edit("constant/g", "value (0 0 -9.81)", "value table ((0 (0 0 -9.81)) (1 (1 0 -9.81)))");
    expectHas(case_.refused().err, {"constant/g:1: value is not constant; expected (x y z)"});
}

TEST_F(FoamDialect, RefusesACellZoneThatIsNotTheMesh)
{
    case_.write(
        "constant/dynamicMeshDict",
        "dynamicFvMesh dynamicMotionSolverFvMesh; motionSolverLibs (fvMotionSolvers); solver solidBody;\n"
        "solidBodyCoeffs { cellZone rotatingZone; solidBodyMotionFunction rotatingMotion;\n"
        "rotatingMotionCoeffs { origin (0 0 0.5); axis (0 0 1); omega 25; } }\n"
    );
    expectHas(
        case_.refused().err, {"constant/dynamicMeshDict:2: cellZone is rotatingZone: OpenFOAM moves these cells alone"}
    );

    // All blocks are in it: ours is the same motion without the zone.
    case_.edit("system/blockMeshDict", "7) (20", "7) rotatingZone (20");
    expectHas(case_.converted(), {"Motion    : rotatingMotion: origin (0 0 0.5), axis (0 0 1), omega 25 rad/s"});
    expectHas(case_.text("ours/constant/dynamicMeshDict"), {"cellZone        none;", "omega           25;"});
    case_.succeed("blockParticles -case ours");

    // So it is of a mover, which names the dialect, too.
    case_.write(
        "constant/dynamicMeshDict", "mover { type motionSolver; motionSolver solidBody; cellZone rotor; "
                                    "solidBodyMotionFunction linearMotion; velocity (1 0 0); }\n"
    );
    expectHas(
        case_.refused().err, {"constant/dynamicMeshDict:1: cellZone is rotor",
                              "The case is written for OpenFOAM 10 or later (mover in constant/dynamicMeshDict)."}
    );
}

TEST_F(FoamDialect, CarriesOverWhetherAndWhenAFunctionRuns)
{
    const std::string probe = "type probes; fields (p); probeLocations ((0 0 0.1)); writeControl timeStep;",
                      off = "off { " + probe + " enabled false; writeInterval 1; }\n",
                      later = "later { " + probe + " timeStart 0.5; timeEnd 0.7; writeInterval 3; }\n";
    for (const std::string& functions : {"functions {\n" + off + later + "}\n", "functions (\n" + off + later + ");\n"})
    {
        const std::string before = case_.text("system/controlDict");
        case_.write("system/controlDict", before + functions);
        expectHas(case_.converted(), {"Functions : 2\n"});
        const Dictionary dict = ours("system/probesDict");
        EXPECT_FALSE(dict.dict("off").flag("enabled"));
        EXPECT_EQ(dict.dict("later").scalar("timeStart", unit::second), 0.5);
        EXPECT_EQ(dict.dict("later").scalar("timeEnd", unit::second), 0.7);
        EXPECT_EQ(case_.text("ours/system/probesDict").find("0.0030000000000000001"), std::string::npos);
        case_.write("system/controlDict", before);
    }
}

TEST_F(FoamDialect, WarnsOfFunctionsThatMeanNothingHereAndOfTheirEntries)
{
    case_.write(
        "system/controlDict",
        case_.text("system/controlDict") +
            "functions\n{\n#includeFunc residuals\nnothing { libs (a); }\nbroken { type probes; fields (p); }\n"
            "coded1 { type coded; code #{ x #}; }\n"
            "good { type probes; fields (p); probeLocations ((0 0 0.1)); writeControl writeTime; frob 3; log yes; "
            "}\n}\n"
    );
    const std::string log = case_.converted();
    expectHas(
        log, {"Functions : 1\n", "system/controlDict:6: the function 'residuals' is of type residuals; it is omitted\n",
              "system/controlDict:7: the function 'nothing' has no type; it is omitted\n",
              "system/controlDict:8: entry 'probeLocations' not found", "the function 'broken' is omitted\n",
              "system/controlDict:9: the function 'coded1' is of type coded; it is omitted\n",
              "system/controlDict:10: frob of 'good' is not used\n"}
    );
    EXPECT_EQ(log.find("'log'"), std::string::npos);
}

TEST_F(FoamDialect, ConvertsForcesOnAllWalls)
{
    const std::string forces =
                          "functions { load { type forces; libs (forces); patches (walls); rho rhoInf; rhoInf 1000; "
                          "CofR (0 0 0.5); writeControl timeStep; writeInterval 5; } }\n",
                      before = case_.text("system/controlDict");
    case_.write("system/controlDict", before + forces);
    EXPECT_EQ(case_.converted().find("'load'"), std::string::npos);
    const Dictionary load = ours("system/probesDict").dict("load");
    EXPECT_EQ(load.word("type"), "forces");
    EXPECT_EQ(load.vector("CofR", unit::metre), Vec(0, 0, 0.5));
    EXPECT_EQ(load.scalar("writeInterval", unit::second), 0.005);
    EXPECT_FALSE(load.has("axes"));

    // The weight of 1 m^3 of water rests on them.
    case_.edit("ours/system/controlDict", "endTime         1;", "endTime         0.01;");
    case_.succeed("blockParticles -case ours");
    case_.succeed("sloshSPHFoam -case ours");
    std::istringstream rows(case_.text("ours/postProcessing/load/0/force.dat"));
    std::string line, last;
    while (std::getline(rows, line))
    {
        last = line;
    }
    double time = 0, fx = 0, fy = 0, fz = 0;
    ASSERT_EQ(std::sscanf(last.c_str(), "%lf (%lf %lf %lf)", &time, &fx, &fy, &fz), 4) << last;
    EXPECT_NEAR(fz / (-9.81 * 1000), 1, 0.05) << last;

    // In a tank that moves OpenFOAM's have the axes of the world.
    case_.write(
        "constant/dynamicMeshDict", "solidBodyMotionFunction oscillatingLinearMotion; amplitude (0.01 0 0); omega 4;\n"
    );
    expectHas(case_.converted(), {"the forces 'load' have a fixed centre of moments; here it moves with the tank"});
    EXPECT_EQ(ours("system/probesDict").dict("load").word("axes"), "inertial");

    // Not on one wall of several: here they are one part.
    case_.edit(
        "system/blockMeshDict", "walls { type wall; faces ((0 3 2 1) ",
        "bottom { type wall; faces ((0 3 2 1)); }\n    walls { type wall; faces ("
    );
    expectHas(
        case_.converted(), {"system/controlDict:4: the forces 'load' do not include those on "
                            "'bottom'; they are omitted, as all walls of the tank are one patch here"}
    );
    for (const std::string patches : {"(walls bottom)", "(\".*\")", "(wall)"})
    {
        std::string named = forces;
        named.replace(named.find("(walls)"), 7, patches);
        case_.write("system/controlDict", before + named);
        expectHas(case_.converted(), {"Functions : 1\n"});
    }
}

TEST_F(FoamDialect, SaysWhatIsConvertedWhereThereIsNoBlockMeshDict)
{
    fs::rename(case_.path() / "system/blockMeshDict", case_.path() / "system/blockMeshDict.tank");
    expectHas(
        case_.refused().err, {"system/blockMeshDict: file not found; expected the blocks of the tank",
                              "blockMesh -dict <file>", "(found: system/blockMeshDict.tank)", "another mesher"}
    );
}

TEST_F(FoamDialect, WritesScaledNumbersAsTheyAreOnPaper)
{
    case_.edit("system/blockMeshDict", "scale 1;", "convertToMeters 0.001;");
    case_.edit(
        "system/blockMeshDict",
        "((-1 -0.5 0) (1 -0.5 0) (1 0.5 0) (-1 0.5 0) (-1 -0.5 1) (1 -0.5 1) (1 0.5 1) (-1 0.5 1))",
        "((-285 -35 0) (285 -35 0) (285 35 0) (-285 35 0) (-285 -35 700) (285 -35 700) (285 35 700) (-285 35 700))"
    );
    case_.converted();
    const std::string tank = case_.text("ours/constant/tankProperties");
    expectHas(tank, {"(-0.285 -0.035 0)", "(0.285 0.035 0.7)"});
}

} // namespace
} // namespace slosh
