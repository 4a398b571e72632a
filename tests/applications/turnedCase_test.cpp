// SPDX-License-Identifier: GPL-3.0-or-later
// foamToSlosh on cases whose gravity does not point along -z: ours are turned.
#include "InterFoamBox.hpp"
#include "installed.hpp"
#include "interFoamCase.hpp"

#include "base/numberText.hpp"
#include "dictionary/Dictionary.hpp"
#include "motion/SolidBodyMotion.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <regex>

namespace slosh
{
namespace
{

namespace fs = std::filesystem;

/// Our axes of theirs, X = R X0.
Mat axes(const Vec& x, const Vec& y, const Vec& z)
{
    Mat R;
    R << x.transpose(), y.transpose(), z.transpose();
    return R;
}
const Vec ex = Vec::UnitX(), ey = Vec::UnitY(), ez = Vec::UnitZ();
const Mat upY = axes(ex, -ez, ey), upX = axes(ey, ez, ex);

std::string text(const Vec& given)
{
    const Vec X = given + Vec::Zero(); // no -0
    return "(" + numberText(X[0]) + " " + numberText(X[1]) + " " + numberText(X[2]) + ")";
}

/// Corners of a hex, as blockMesh counts them.
std::string corners(const Vec& min, const Vec& max, const Mat& toTheirs)
{
    std::string list;
    for (const double z : {min.z(), max.z()})
    {
        list += text(toTheirs * Vec(min.x(), min.y(), z)) + text(toTheirs * Vec(max.x(), min.y(), z)) +
                text(toTheirs * Vec(max.x(), max.y(), z)) + text(toTheirs * Vec(min.x(), max.y(), z));
    }
    return list;
}

/// A 2D tank that pitches and sways, with probes, a gauge and forces, written in turned axes.
void writeRollingTank(const InterFoamBox& theCase, const Mat& R)
{
    const Mat back = R.transpose();
    const auto point = [&](double x, double y, double z) { return text(back * Vec(x, y, z)); };
    theCase.write("constant/g", "dimensions [0 1 -2 0 0 0 0]; value " + point(0, 0, -9.81) + ";\n");
    theCase.write(
        "system/blockMeshDict", "scale 0.1; vertices (" + corners(Vec(-3, -0.5, 0), Vec(3, 0.5, 4), back) +
                                    ");\nblocks (hex (0 1 2 3 4 5 6 7) (20 1 10) simpleGrading (1 1 1));\n"
                                    "boundary (walls { type wall; faces ((0 3 2 1) (4 5 6 7) (1 2 6 5) (3 0 4 7)); }\n"
                                    "frontAndBack { type empty; faces ((0 1 5 4) (2 3 7 6)); });\n"
    );
    theCase.write(
        "system/setFieldsDict", "defaultFieldValues (volScalarFieldValue alpha.water 0);\nregions (boxToCell { box " +
                                    point(-9, -9, -9) + " " + point(9, 9, 0.2) +
                                    "; fieldValues (volScalarFieldValue alpha.water 1); });\n"
    );
    theCase.write(
        "constant/dynamicMeshDict",
        "solidBodyMotionFunction multiMotion;\n"
        "sway { solidBodyMotionFunction oscillatingLinearMotion; amplitude " +
            point(0.02, 0, 0) + "; omega 6; }\npitch { solidBodyMotionFunction oscillatingRotatingMotion; origin " +
            point(0, 0, 0.1) + "; amplitude " + point(0, 4, 0) + "; omega 5; }\n"
    );
    theCase.write(
        "system/controlDict", theCase.text("system/controlDict") +
                                  "endTime 0.03; writeInterval 0.03; functions {\n"
                                  "pressure { type probes; fields (p); writeControl timeStep; probeLocations (" +
                                  point(-0.3, 0, 0.05) + point(0.3, 0, 0.1) +
                                  "); }\ngauge { type interfaceHeight; locations (" + point(-0.2, 0, 0) +
                                  "); writeControl timeStep; }\nload { type forces; patches (walls); CofR " +
                                  point(0, 0, 0.1) + "; writeControl timeStep; } }\n"
    );
}

/// All samples of a run of the converted case.
std::map<std::string, std::string> samplesOf(const InterFoamBox& theCase)
{
    theCase.succeed("foamToSlosh -to ours -spacing 0.02");
    theCase.succeed("blockParticles -case ours");
    theCase.succeed("sloshSPHFoam -case ours");
    std::map<std::string, std::string> samples;
    for (const std::string file : {"pressure/0/p", "gauge/0/height.dat", "load/0/force.dat", "load/0/moment.dat"})
    {
        samples[file] = theCase.text("ours/postProcessing/" + file);
    }
    return samples;
}

TEST(TurnedCase, HasTheSamplesOfTheUprightOne)
{
    const InterFoamBox upright, yUp, xUp;
    writeRollingTank(upright, Mat::Identity());
    writeRollingTank(yUp, upY);
    writeRollingTank(xUp, upX);
    const auto samples = samplesOf(upright);
    EXPECT_GT(std::count(samples.at("pressure/0/p").begin(), samples.at("pressure/0/p").end(), '\n'), 20);
    EXPECT_EQ(samplesOf(yUp), samples);
    EXPECT_EQ(yUp.text("ours/constant/tankProperties"), upright.text("ours/constant/tankProperties"));
    EXPECT_EQ(yUp.text("ours/constant/g"), upright.text("ours/constant/g"));
    EXPECT_EQ(samplesOf(xUp), samples);
}

TEST(TurnedCase, SaysHowItIsTurnedAndNamesPointsAsTheyStand)
{
    const InterFoamBox theCase;
    writeRollingTank(theCase, upY);
    theCase.edit("system/controlDict", "(0.3 0.1 0)", "(0.3 0.7 0)");
    expectHas(
        theCase.succeed("foamToSlosh -to ours"),
        {"2D, a box, 0.6 0.1 0.4 m, 0.024 m^3", "0.2 m deep",
         "Axes      : turned so that gravity points along -z: x y z are x -z y of the interFoam case\n",
         ": the point (0.3 0.7 0) of probeLocations"}
    );
}

TEST(TurnedCase, CanHaveNoGravityAlongItsEmptyDirection)
{
    const InterFoamBox theCase;
    writeRollingTank(theCase, upY);
    theCase.write("constant/g", "dimensions [0 1 -2 0 0 0 0]; value (0 0 -9.81);\n");
    expectHas(
        theCase.refused().err, {"constant/g:1: gravity is along the direction that is empty in system/blockMeshDict"}
    );
    // Without gravity its section stands upright all the same.
    theCase.write("constant/g", "dimensions [0 1 -2 0 0 0 0]; value (0 0 0);\n");
    expectHas(theCase.converted(), {"x y z are x -z y of the interFoam case"});
}

/// A motion of theirs, and what is written to its table.
struct Motion
{
    std::string name, entries, table;
};

void PrintTo(const Motion& motion, std::ostream* out)
{
    *out << motion.name;
}

class TurnedMotionOf : public testing::TestWithParam<std::tuple<std::string, Motion>>
{
};

/// R T R^-1 at any time, to rounding, with its velocities and accelerations.
std::unique_ptr<SolidBodyMotion> motionIn(const fs::path& folder)
{
    const std::string file = "constant/dynamicMeshDict";
    return SolidBodyMotion::read(Dictionary::read(folder / file, file), folder);
}

TEST_P(TurnedMotionOf, IsTheirsInTurnedAxes)
{
    const auto& [up, motion] = GetParam();
    const Mat R = up == "y" ? upY : up == "x" ? upX : up == "minusX" ? axes(ey, -ez, -ex) : axes(ex, -ey, -ez);
    const InterFoamBox theCase;
    theCase.write("constant/g", "value " + text(R.transpose() * Vec(0, 0, -9.81)) + ";\n");
    theCase.write(
        "system/setFieldsDict",
        [&]
        {
            const Vec half = R.transpose() * Vec(9, 9, -0.2), deep = R.transpose() * Vec(-9, -9, -9);
            return "regions (boxToCell { box " + text(half) + text(deep) +
                   "; fieldValues (volScalarFieldValue alpha.water 1); });\n";
        }()
    );
    // Its corners are at 1 m from the origin.
    theCase.write(
        "system/blockMeshDict",
        "vertices (" + corners(Vec(-1, -1, -1), Vec(1, 1, 1), Mat::Identity()) +
            ");\nblocks (hex (0 1 2 3 4 5 6 7) (1 1 1) simpleGrading (1 1 1));\ndefaultPatch { type wall; }\n"
    );
    theCase.write("constant/dynamicMeshDict", "solidBodyMotionFunction " + motion.name + ";\n" + motion.entries);
    theCase.write("constant/table.dat", motion.table);
    theCase.converted();
    const auto theirs = motionIn(theCase.path()), ours = motionIn(theCase.path() / "ours");
    for (double t = 0; t <= 1; t += 0.0625)
    {
        const RigidState a = theirs->at(t), b = ours->at(t);
        EXPECT_LT((R * a.c - b.c).norm(), 1e-13) << t;
        EXPECT_LT((R * a.R * R.transpose() - b.R).norm(), 1e-13) << t;
        EXPECT_LT((R * a.velocity - b.velocity).norm(), 1e-12 * (1 + a.velocity.norm())) << t;
        EXPECT_LT((R * a.omega - b.omega).norm(), 1e-12 * (1 + a.omega.norm())) << t;
        EXPECT_LT((R * a.acceleration - b.acceleration).norm(), 1e-11 * (1 + a.acceleration.norm())) << t;
        EXPECT_LT((R * a.omegaDot - b.omegaDot).norm(), 1e-11 * (1 + a.omegaDot.norm())) << t;
    }
    EXPECT_EQ(ours->lastTime(), theirs->lastTime());
}

const std::string sixColumns = "4\n(\n(0 ((0 0 0) (0 0 0)))\n(0.4 ((0.1 0.2 -0.3) (5 -10 15)))\n"
                               "(0.8 ((0.3 -0.1 0.2) (-20 4 3)))\n(1.2 ((0 0.1 0) (2 30 -7)))\n)\n",
                  oneAngle = "((0 ((0 0 0) (0 0 0))) (0.5 ((0.1 0 0) (0 0 9))) (2 ((0 0.1 0) (0 0 -4))))\n";

INSTANTIATE_TEST_SUITE_P(
    Of, TurnedMotionOf,
    testing::Combine(
        testing::Values("y", "x", "minusX", "minusZ"),
        testing::Values(
            Motion{"linearMotion", "velocity (0.1 -0.2 0.3);", ""},
            Motion{
                "oscillatingLinearMotion",
                "oscillatingLinearMotionCoeffs { amplitude (0.1 -0.2 0.3); omega 4; phaseShift 0.1; verticalShift (0.1 "
                "0.2 0.3); } SDACoeffs { }",
                ""},
            Motion{
                "oscillatingLinearMotion",
                "amplitude table ((0 (0 0 0)) (0.3 (0.1 -0.2 0.3)) (3 (1 2 3)));\n"
                "omega { type table; values ((0 1) (2 3)); }\n"
                "verticalShift { type constant; value (0.1 0 -0.3); } phaseShift sine; phaseShiftCoeffs { frequency 1; "
                "}",
                ""},
            Motion{
                "oscillatingLinearMotion",
                "amplitude { type sine; frequency 0.3; amplitude 2; scale (0.1 -0.2 0.3); level { type table; values "
                "((0 (0 0 0)) (3 (1 2 3))); } } omega 4; verticalShift cosine; verticalShiftCoeffs { frequency 2; }",
                ""},
            Motion{"rotatingMotion", "origin (0.1 0.2 -0.3); axis (1 2 3); omega table ((0 0) (2 4));", ""},
            Motion{"axisRotationMotion", "origin (0.1 0.2 -0.3); radialVelocity (10 -20 30);", ""},
            Motion{"oscillatingRotatingMotion", "origin (0.1 0.2 -0.3); amplitude (10 -20 30); omega 4;", ""},
            Motion{"oscillatingRotatingMotion", "origin (0 0 1); amplitude (0 0 30); omega constant 4;", ""},
            Motion{
                "oscillatingRotatingMotion", "origin (0 1 0); amplitude table ((0 (0 0 0)) (2 (10 20 30))); omega 4;",
                ""},
            Motion{"tabulated6DoFMotion", "CofG (0.1 0.2 -0.3); timeDataFileName \"constant/table.dat\";", sixColumns},
            Motion{"tabulated6DoFMotion", "CofG (0 0 0); timeDataFileName \"<case>/constant/table.dat\";", oneAngle},
            Motion{
                "multiMotion",
                "a { solidBodyMotionFunction oscillatingRotatingMotion; origin (0 0 1); amplitude (3 4 5); omega 2; }\n"
                "b { solidBodyMotionFunction tabulated6DoFMotion; CofG (1 0 0); timeDataFileName "
                "\"constant/table.dat\"; }\n"
                "c { solidBodyMotionFunction linearMotion; linearMotionCoeffs { velocity (1 2 3); } }\n",
                sixColumns}
        )
    )
);

// Roll about x is the same about an x that stays; sway and heave are not.
TEST(TurnedCase, TurnsShipRollAloneAboutAnAxisThatStays)
{
    const InterFoamBox theCase;
    writeRollingTank(theCase, upY);
    theCase.write(
        "constant/dynamicMeshDict",
        "solidBodyMotionFunction SDA;\nCofG (0 0.1 0); lamda 50; rollAmax 0.2; rollAmin 0.1; heaveA 0; swayA 0; "
        "Q 2; Tp 13.93; Tpn 11.93; dTi 0.059; dTp -0.001;\n"
    );
    theCase.converted();
    const RigidState a = motionIn(theCase.path())->at(0.7), b = motionIn(theCase.path() / "ours")->at(0.7);
    EXPECT_GT((a.R - Mat::Identity()).norm(), 0.05);
    EXPECT_LT((a.R - b.R).norm(), 1e-13);
    EXPECT_LT((Vec(a.c[0], -a.c[2], a.c[1]) - b.c).norm(), 1e-13);
}

TEST(TurnedCase, RefusesMotionsThatCannotBeTurned)
{
    const InterFoamBox theCase;
    writeRollingTank(theCase, upY);
    theCase.write(
        "constant/dynamicMeshDict",
        "solidBodyMotionFunction SDA;\nCofG (0 0 0); lamda 50; rollAmax 0.2; rollAmin 0.1; heaveA 3.79; swayA 2.34; "
        "Q 2; Tp 13.93; Tpn 11.93; dTi 0.059; dTp -0.001;\n"
    );
    expectHas(
        theCase.refused().err,
        {"constant/dynamicMeshDict:1: solidBodyMotionFunction is SDA, whose formula has fixed axes"}
    );
    theCase.write(
        "constant/dynamicMeshDict", "solidBodyMotionFunction oscillatingLinearMotion; omega 4;\n"
                                    "amplitude { type linearRamp; start 0; duration 1; }\n"
    );
    expectHas(
        theCase.refused().err, {"constant/dynamicMeshDict:2: amplitude is of type linearRamp, which cannot be turned"}
    );
}

TEST(TurnedCase, OfOpenFOAMsDamBreakHasTheVolumeThatCheckMeshHas)
{
    if (const std::string missing = missingForInterFoamCases(); !missing.empty())
    {
        GTEST_SKIP() << missing;
    }
    const InterFoamCase theCase("damBreak/damBreak");
    const std::string log = theCase.succeed("foamToSlosh -to ours");
    expectHas(log, {"2D, a prism of 8 sides", "x y z are x -z y of the interFoam case", "the patch 'atmosphere'"});
    const std::string mesh = succeedInShell(theCase, "blockMesh > /dev/null; checkMesh -constant");
    std::smatch ours, theirs;
    ASSERT_TRUE(std::regex_search(log, ours, std::regex(", ([0-9.e+-]+) m\\^3\n"))) << log;
    ASSERT_TRUE(std::regex_search(mesh, theirs, std::regex("Total volume = ([0-9.e+-]+)\\."))) << mesh;
    EXPECT_NEAR(std::stod(ours[1]) / std::stod(theirs[1]), 1, 1e-5);
    expectHas(theCase.succeed("blockParticles -case ours"), {"2D tank, a prism"});
}

} // namespace
} // namespace slosh
