// SPDX-License-Identifier: GPL-3.0-or-later
// foamToSlosh: cases of interFoam, made here out of a tutorial's, become cases of ours.
#include "CaseDirectory.hpp"

#include "dictionary/Dictionary.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace slosh
{
namespace
{

namespace fs = std::filesystem;

const std::string foamFile = "FoamFile { version 2.0; format ascii; class dictionary; object it; }\n";

/// A 2D tank whose section is 4 m x 3 m without its corners: three blocks.
const std::string chamfered = foamFile + R"(scale 0.1;
b -5; f 5;
vertices
(
    ($b -15 0) ($b 15 0) ($b 20 5) ($b -20 5) ($b 20 20) ($b -20 20) ($b 10 30) ($b -10 30)
    ($f -15 0) ($f 15 0) ($f 20 5) ($f -20 5) ($f 20 20) ($f -20 20) ($f 10 30) ($f -10 30)
);
blocks
(
    hex (0 1 2 3 8 9 10 11) (40 5 1) simpleGrading (1 1 1)
    hex (3 2 4 5 11 10 12 13) liquid (40 15 1) simpleGrading ((0.5 0.5 2) 1 1)
    hex (5 4 6 7 13 12 14 15) (40 10 1) edgeGrading (1 1 1 1 1 1 1 1 1 1 1 1)
);
edges ( line 0 1 );
patches
(
    wall walls ((0 1 9 8) (1 2 10 9) (2 4 12 10) (4 6 14 12) (6 7 15 14) (7 5 13 15) (5 3 11 13) (3 0 8 11))
    empty frontAndBack ((0 3 2 1) (3 5 4 2) (5 7 6 4) (8 9 10 11) (11 10 12 13) (13 12 14 15))
);
)";

/// A box of 2 x 2 x 2 blocks, in one list of vertices, from (0 0 0) to (4 2 1), all of it one patch.
std::string boxOfEight(const std::string& shape = "")
{
    std::string vertices, blocks;
    const auto label = [](int i, int j, int k) { return std::to_string(i + 3 * j + 9 * k); };
    for (int k = 0; k < 3; ++k)
    {
        for (int j = 0; j < 3; ++j)
        {
            for (int i = 0; i < 3; ++i)
            {
                // Inner vertices may lie where they like.
                vertices += "(" + std::to_string(i == 1 ? 1.3 : 2.0 * i) + " " + std::to_string(1.0 * j) + " " +
                            std::to_string(0.5 * k) + ")\n";
                if (i < 2 && j < 2 && k < 2 && !(shape == "L" && i == 1 && k == 1))
                {
                    blocks += "hex (" + label(i, j, k) + " " + label(i + 1, j, k) + " " + label(i + 1, j + 1, k) + " " +
                              label(i, j + 1, k) + " " + label(i, j, k + 1) + " " + label(i + 1, j, k + 1) + " " +
                              label(i + 1, j + 1, k + 1) + " " + label(i, j + 1, k + 1) +
                              ") (1 1 1) simpleGrading (1 1 1)\n";
                }
            }
        }
    }
    return foamFile + "convertToMeters 1;\nvertices (\n" + vertices + ");\nblocks (\n" + blocks +
           ");\nedges ();\ndefaultPatch { name walls; type wall; }\nboundary ();\nmergePatchPairs ();\n";
}

class FoamToSlosh : public testing::Test
{
protected:
    /// An interFoam case: a box tank in the xz plane, at rest.
    FoamToSlosh()
    {
        const fs::path from = fs::path(SLOSH_SOURCE) / "tutorials/workPrecision/interFoam";
        fs::remove_all(case_.path());
        fs::create_directories(case_.path());
        for (const std::string folder : {"constant", "system"})
        {
            fs::copy(from / folder, case_.path() / folder, fs::copy_options::recursive);
        }
    }

    void setLiquid(const std::string& regions) const
    {
        case_.write(
            "system/setFieldsDict",
            foamFile + "defaultFieldValues (volScalarFieldValue alpha.water 0);\nregions (" + regions + ");\n"
        );
    }

    static std::string box(const std::string& corners, const std::string& fraction = "1")
    {
        return "boxToCell { box " + corners + "; fieldValues (volScalarFieldValue alpha.water " + fraction + "); }\n";
    }

    Dictionary made(const std::string& file) const { return Dictionary::read(case_.path() / "ours" / file, file); }

    std::string convert(const std::string& options = "") const
    {
        return case_.succeed("foamToSlosh -to ours " + options);
    }

    void expectRefused(const std::vector<std::string>& words) const
    {
        const auto before = case_.tree();
        const Ended ended = case_.run("foamToSlosh -to ours");
        EXPECT_EQ(ended.status, 1);
        for (const std::string& word : words)
        {
            EXPECT_NE(ended.err.find(word), std::string::npos) << word << "\n" << ended.err;
        }
        EXPECT_EQ(case_.tree(), before);
    }

    static void expectSays(const std::string& text, const std::vector<std::string>& words)
    {
        for (const std::string& word : words)
        {
            EXPECT_NE(text.find(word), std::string::npos) << word << "\n" << text;
        }
    }

    CaseDirectory case_;
};

TEST_F(FoamToSlosh, MakesACaseThatRunsAsItIs)
{
    case_.edit("system/tank", "endTime         8;", "endTime         0.02;");
    const std::string log = convert("-spacing 0.05");
    expectSays(log, {"2D, a box", "0.5 m deep, 0.05 m^3", "Spacing   : 0.05 m, 10 in the depth\n"});
    EXPECT_EQ(made("constant/tankProperties").vector("max", unit::metre), Vec(0.5, 0.05, 0.75));
    expectSays(case_.succeed("blockParticles -case ours"), {"2D tank:", "Liquid particles: 200\n", "= rho0 V to"});
    EXPECT_EQ(case_.succeed("sloshSPHFoam -case ours").find("Not used"), std::string::npos);
    EXPECT_TRUE(fs::exists(case_.path() / "ours/0.02/lagrangian/fluid/positions"));
}

TEST_F(FoamToSlosh, FindsTheOutlineOfTheBlocksAndItsArea)
{
    case_.write("system/blockMeshDict", chamfered);
    setLiquid(box("(-9 -9 -9) (9 9 1.25)"));
    // 4 x 3 less two triangles of 0.5 x 0.5 and two of 1 x 1; the liquid loses the two lower ones.
    expectSays(convert(), {"2D, a prism of 8 sides", "10.75 m^3", "1.25 m deep, 4.75 m^3"});
    const Dictionary tank = made("constant/tankProperties");
    EXPECT_EQ(tank.word("type"), "prism");
    EXPECT_EQ(tank.word("section"), "yz");
    EXPECT_EQ(tank.word("plane"), "yz");
    EXPECT_EQ(tank.scalars("extent", unit::metre), (std::vector<double>{-0.5, 0.5}));
    EXPECT_EQ(tank.scalar("fillLevel", unit::metre), 1.25);
    const std::string text = case_.text("ours/constant/tankProperties");
    expectSays(text, {"((-2 0.5) (-1.5 0) (1.5 0) (2 0.5) (2 2) (1 3) (-1 3) (-2 2))"});
}

TEST_F(FoamToSlosh, TakesManyBlocksForOneBoxAndStacksAlongAnyAxis)
{
    case_.write("system/blockMeshDict", boxOfEight());
    setLiquid(box("(-9 -9 -9) (9 9 0.6)"));
    expectSays(convert(), {"3D, a box", "8 m^3", "0.6 m deep, 4.8 m^3", "about 50000 liquid particles"});
    const Dictionary tank = made("constant/tankProperties");
    EXPECT_EQ(tank.vector("min", unit::metre), Vec(0, 0, 0));
    EXPECT_EQ(tank.vector("max", unit::metre), Vec(4, 2, 1));
    EXPECT_FALSE(tank.has("plane"));

    case_.remove("ours");
    case_.write("system/blockMeshDict", boxOfEight("L"));
    expectSays(convert(), {"3D, a prism of 6 sides", "5.3 m^3"});
    expectSays(
        case_.text("ours/constant/tankProperties"), {"xz;", "((0 0) (4 0) (4 0.5) (1.3 0.5) (1.3 1) (0 1))", "(0 2);"}
    );
}

TEST_F(FoamToSlosh, TakesBoxesOfLiquidWhereTheyDoNotFillTheTank)
{
    setLiquid(box("(-9 -9 -9) (-0.1 9 0.3)") + box("(0.1 -1 0.2) (0.3 1 0.4)") + box("(7 7 7) (8 8 8)", "0.4"));
    convert("-spacing 0.05");
    const Dictionary liquid = made("constant/tankProperties").dict("liquid");
    EXPECT_EQ(liquid.keys(), (std::vector<std::string>{"box0", "box1"}));
    EXPECT_EQ(liquid.dict("box0").vector("min", unit::metre), Vec(-0.5, -0.05, 0));
    EXPECT_EQ(liquid.dict("box1").vector("max", unit::metre), Vec(0.3, 0.05, 0.4));
    expectSays(case_.succeed("blockParticles -case ours"), {"Liquid particles: 64\n"}); // 8 x 6 and 4 x 4
}

TEST_F(FoamToSlosh, CopiesTheMotionByteForByteWithItsTableAndWhatItIncludes)
{
    case_.write(
        "constant/dynamicMeshDict",
        "solidBodyMotionFunction multiMotion; // mine\n#include \"../system/tank\"\n"
        "a { solidBodyMotionFunction tabulated6DoFMotion; CofG ($left 0 0); timeDataFileName \"<constant>/six\"; }\n"
    );
    case_.write("constant/six", "2((0 ((0 0 0) (0 0 0)))\n(5 ((0.1 0 0) (0 0 0))))\n");
    ASSERT_EQ(std::system(("gzip '" + (case_.path() / "constant/six").string() + "'").c_str()), 0);
    expectSays(
        convert("-spacing 0.05"),
        {"2 rows from 0 to 5 s", "endTime is 8, later than the motion's table; the run ends with the table at 5 s"}
    );
    for (const std::string file : {"constant/dynamicMeshDict", "constant/six.gz", "system/tank"})
    {
        EXPECT_EQ(case_.text("ours/" + file), case_.text(file));
    }
    EXPECT_EQ(made("system/controlDict").scalar("endTime", unit::second), 5);
    expectSays(case_.succeed("blockParticles -case ours"), {"Liquid particles: 200\n"});
}

TEST_F(FoamToSlosh, TakesProbesAndTheirTimesAndTellsWhatItLeavesOut)
{
    case_.write(
        "system/samples", "probes { type probes; fields (U p); writeControl timeStep; writeInterval 4;\n"
                          "probeLocations ((0.5 0 0.1) (0 0 9) (0.1 0 0)); }\n"
                          "walls { type surfaces; }\n"
    );
    case_.write(
        "0/U", foamFile + "boundaryField { \"wall.*\" { type movingWallVelocity; }\n"
                          "roof { type pressureInletOutletVelocity; } }\n"
    );
    case_.write("constant/turbulenceProperties", foamFile + "simulationType RAS;\n");
    const std::string log = convert();
    expectSays(
        log, {"system/samples:1: the field U of 'probes' is omitted; probes sample p",
              "system/samples:2: the point (0 0 9) of probeLocations is outside the tank; it is omitted",
              "system/samples:3: the function 'walls' is of type surfaces; it is omitted",
              ": the patch 'roof' is open (pressureInletOutletVelocity in 0/U)",
              "constant/turbulenceProperties:2: simulationType is RAS; turbulence is not modelled", "the gas 'air', "}
    );
    EXPECT_EQ(log.find("the patch 'walls'"), std::string::npos);
    const Dictionary probes = made("system/probesDict").dict("probes");
    EXPECT_EQ(probes.vectors("probeLocations", unit::metre), (std::vector<Vec>{Vec(0.5, 0, 0.1), Vec(0.1, 0, 0)}));
    EXPECT_EQ(probes.word("writeControl"), "runTime");
    EXPECT_EQ(probes.scalar("writeInterval", unit::second), 4 * 0.00125);
}

TEST_F(FoamToSlosh, TakesAViscosityThatASpacingShowsAndNoOther)
{
    convert();
    const Dictionary fluid = made("constant/fluidProperties");
    EXPECT_EQ(fluid.dict("viscosity").word("type"), "lowDissipationRiemann");
    EXPECT_NEAR(fluid.dict("equationOfState").scalar("speedOfSound", unit::velocity), 10 * std::sqrt(9.81 * 0.5), 1e-4);
    case_.remove("ours");
    case_.edit("constant/transportProperties", "nu              1e-6", "nu              0.01");
    convert();
    EXPECT_EQ(made("constant/fluidProperties").dict("viscosity").word("type"), "laminar");
    EXPECT_EQ(made("constant/fluidProperties").dict("viscosity").scalar("nu", unit::kinematicViscosity), 0.01);
}

TEST_F(FoamToSlosh, RefusesWhatHasNoStraightEdges)
{
    case_.write("system/blockMeshDict", chamfered);
    case_.edit(
        "system/blockMeshDict", "edges ( line 0 1 );",
        "edges ( line 0 1\narc 0 1 (0 0 -1)\nspline 2 4 ((0 21 10)) arc 1 2 (0 18 2) );\nfaces (project (0 1 9 "
        "8) dome);"
    );
    case_.edit("system/blockMeshDict", "($b -15 0) ($b 15 0)", "($b -15 0) project ($b 15 0) (dome)");
    expectRefused(
        {"the tank cannot be converted", "system/blockMeshDict:6: a vertex projected on surfaces by 'vertices'",
         "system/blockMeshDict:16: the first of 3 curved edges (arc spline)",
         "system/blockMeshDict:18: faces projected on surfaces by 'faces'"}
    );
}

TEST_F(FoamToSlosh, RefusesBlocksThatAreNoPrismOfOnePolygon)
{
    case_.write("system/blockMeshDict", chamfered);
    case_.edit("system/blockMeshDict", "($f 10 30)", "($f 9 30)");
    expectRefused({"system/blockMeshDict: the blocks are no prism"});

    // A ring of four blocks.
    std::string ring = "vertices (";
    for (const std::string x : {"0", "1"})
    {
        for (const std::string yz : {"0 0", "3 0", "3 3", "0 3", "1 1", "2 1", "2 2", "1 2"})
        {
            ring += "(" + x + " " + yz + ") ";
        }
    }
    case_.write(
        "system/blockMeshDict",
        foamFile + ring +
            ");\nblocks (hex (0 1 5 4 8 9 13 12) (1 1 1) simpleGrading (1 1 1)\n"
            "hex (1 2 6 5 9 10 14 13) (1 1 1) simpleGrading (1 1 1) hex (2 3 7 6 10 11 15 14) (1 1 1) simpleGrading "
            "(1 1 1)\nhex (3 0 4 7 11 8 12 15) (1 1 1) simpleGrading (1 1 1));\ndefaultPatch { type wall; }\n"
    );
    expectRefused({"system/blockMeshDict: the section of the blocks is not one polygon", "expected no hole"});

    case_.write("system/blockMeshDict", boxOfEight());
    case_.edit(
        "system/blockMeshDict", "type wall; }\nboundary ()",
        "type wall; }\nboundary (side { type empty; faces ((0 1 4 3)); })"
    );
    expectRefused({"system/blockMeshDict: the empty faces are not the two ends of the tank"});
}

TEST_F(FoamToSlosh, NamesWhatElseItCannotConvert)
{
    const auto refusedWith = [&](const std::string& file, const std::string& from, const std::string& to,
                                 const std::vector<std::string>& words)
    {
        const std::string before = case_.text(file);
        case_.edit(file, from, to);
        expectRefused(words);
        case_.write(file, before);
    };
    refusedWith(
        "constant/g", "(0 0 -9.81)", "(0 -9.81 -1)", {": gravity is not along an axis; expected a case turned"}
    );
    refusedWith(
        "constant/dynamicMeshDict", "staticFvMesh", "dynamicRefineFvMesh",
        {"constant/dynamicMeshDict:10: unknown dynamicFvMesh type 'dynamicRefineFvMesh'", "Valid dynamicFvMesh types"}
    );
    refusedWith(
        "system/setFieldsDict", "    boxToCell\n", "    sphereToCell\n",
        {"system/setFieldsDict:20: the region is sphereToCell; expected boxToCell"}
    );
    refusedWith("system/setFieldsDict", "alpha.water 1", "alpha.water 0.7", {"is 0.7; expected 1"});
    refusedWith("system/setFieldsDict", "$liquidTo 1 $depth", "$liquidTo 1 -2", {"set no liquid in the tank"});
    refusedWith(
        "constant/transportProperties", "(water air)", "(air water)",
        {"phases does not begin", "constant/transportProperties:10"}
    );
    refusedWith(
        "system/blockMeshDict", "boundary\n", "mergePatchPairs ((a b));\nboundary\n",
        {"blocks joined by 'mergePatchPairs'"}
    );
    refusedWith(
        "system/blockMeshDict", "hex (4 5 6 7 8 9 10 11)", "hex (4 5 6 7 8 9 10 12)",
        {"system/blockMeshDict:26: ", "8 labels from 0 to 11"}
    );

    case_.write("system/snappyHexMeshDict", foamFile);
    expectRefused({"system/snappyHexMeshDict: the mesher gives the tank another shape"});
    case_.remove("system/snappyHexMeshDict");
    case_.write("system/blockMeshDict.m4", case_.text("system/blockMeshDict"));
    case_.remove("system/blockMeshDict");
    expectRefused({"m4 system/blockMeshDict.m4 > system/blockMeshDict"});
}

TEST_F(FoamToSlosh, WritesNothingWhereAFolderHoldsSomethingOrAnOptionIsWrong)
{
    case_.write("ours/mine", "");
    expectRefused({"ours: the folder is not empty"});
    EXPECT_NE(case_.run("foamToSlosh").err.find("-to <dir>"), std::string::npos);
    EXPECT_NE(
        case_.run("foamToSlosh -to new -spacing -1").err.find("-spacing is -1; expected a number > 0 [m]"),
        std::string::npos
    );
    EXPECT_FALSE(fs::exists(case_.path() / "new"));
}

} // namespace
} // namespace slosh
