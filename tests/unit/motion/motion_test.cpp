// SPDX-License-Identifier: GPL-3.0-or-later
#include "motion/MotionFunction.hpp"

#include "base/CaseError.hpp"
#include "base/writeFile.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <unistd.h>

namespace slosh
{
namespace
{

namespace fs = std::filesystem;
constexpr double degree = 0.017453292519943295;

std::unique_ptr<SolidBodyMotion>
motionOf(const std::string& function, const std::string& coeffs, const std::string& folder = ".")
{
    const Dictionary dict = Dictionary::parse(
        "dynamicFvMesh dynamicMotionSolverFvMesh; motionSolver solidBody;\nsolidBodyMotionFunction " + function +
            ";\n" + function + "Coeffs { " + coeffs + " }\n",
        "constant/dynamicMeshDict"
    );
    return SolidBodyMotion::read(dict, folder);
}

const std::vector<std::pair<std::string, std::string>>& allMotions()
{
    static const std::vector<std::pair<std::string, std::string>> motions{
        {"linearMotion", "velocity (0.1 -0.2 0.3);"},
        {"oscillatingLinearMotion", "amplitude (0.03 0.01 -0.02); omega 4;"},
        {"oscillatingLinearMotion", "amplitude (0.03 0.01 -0.02); omega 4; phaseShift 0.3;"},
        {"oscillatingLinearMotion", "amplitude scale; amplitudeCoeffs { scale halfCosineRamp; scaleCoeffs { start 0.1; "
                                    "duration 3; } value (0.03 0 "
                                    "0.01); } omega { type sine; frequency 0.3; amplitude 0.2; level 4; } phaseShift "
                                    "0.3; verticalShift polynomial "
                                    "(((0.1 0 0) (1 1 1)) ((0 0.01 0) (2 2 2)));"},
        {"rotatingMotion", "origin (0.1 0.2 0.3); axis (1 2 3); omega 1.5;"},
        {"rotatingMotion", "origin (0.1 0.2 0.3); axis (1 2 3); omega table ((0 0) (1 2) (5 1));"},
        {"axisRotationMotion", "origin (0.1 0.2 0.3); radialVelocity (30 -20 10);"},
        {"oscillatingRotatingMotion", "origin (0 0 0.31); amplitude (8 5 -3); omega 4;"},
        {"oscillatingRotatingMotion",
         "origin (0 0 0.31); amplitude table ((0 (0 0 0)) (5 (8 5 -3))); omega constant 4;"},
        {"SDA", "CofG (0 0 0.3); lamda 50; rollAmax 0.22654; rollAmin 0.10472; heaveA 3.79; swayA 2.34; Q 2; Tp 13.93; "
                "Tpn 11.93; dTi 0.059; dTp -0.001;"},
        {"multiMotion", "sway { solidBodyMotionFunction oscillatingLinearMotion; oscillatingLinearMotionCoeffs { "
                        "amplitude (0 0.02 0); omega 3; } } roll { solidBodyMotionFunction oscillatingRotatingMotion; "
                        "oscillatingRotatingMotionCoeffs { origin (0 0 0.2); amplitude (10 0 4); omega 5; } }"}};
    return motions;
}

TEST(SolidBodyMotion, EveryFunctionIsTriedHere)
{
    std::set<std::string> tried = {"tabulated6DoFMotion"}; // below: it needs a file
    for (const auto& motion : allMotions())
    {
        tried.insert(motion.first);
    }
    const std::vector<std::string> names = namesOf(MotionFunction::choices());
    EXPECT_EQ(tried, std::set<std::string>(names.begin(), names.end()));
}

TEST(SolidBodyMotion, VelocityAndAccelerationOfEveryFunctionAreThoseOfItsPosition)
{
    const Vec X(0.4, -0.3, 0.2);
    constexpr double h = 1e-4;
    for (const auto& [name, coeffs] : allMotions())
    {
        const auto motion = motionOf(name, coeffs);
        for (const double t : {0.3, 1.7, 4.1})
        {
            const auto x = [&](double time) { return motion->at(time).pointToInertial(X); };
            const RigidState state = motion->at(t);
            const double speed = 1 + state.velocityAt(X).norm();
            EXPECT_NEAR((state.velocityAt(X) - (x(t + h) - x(t - h)) / (2 * h)).norm(), 0, 1e-6 * speed) << name;
            EXPECT_NEAR((state.accelerationAt(X) - (x(t + h) - 2 * x(t) + x(t - h)) / (h * h)).norm(), 0, 3e-6 * speed)
                << name;
            EXPECT_NEAR((state.R * state.R.transpose() - Mat::Identity()).norm(), 0, 1e-14) << name;
        }
    }
}

TEST(SolidBodyMotion, FollowsOpenFOAMsSigns)
{
    // OpenFOAM: quaternion(XYZ, amplitude sin(omega t)) about the origin; positive roll lowers the side y < 0 ... and
    // lifts y > 0: counter-clockwise seen from +x.
    const RigidState roll =
        motionOf("oscillatingRotatingMotion", "origin (0 0 0); amplitude (90 0 0); omega 1;")->at(std::asin(1.0));
    EXPECT_NEAR((roll.pointToInertial(Vec(0, 1, 0)) - Vec(0, 0, 1)).norm(), 0, 1e-15);
    // XYZ: z is turned first, then y, then x.
    const RigidState both =
        motionOf("oscillatingRotatingMotion", "origin (0 0 0); amplitude (90 0 90); omega 1;")->at(std::asin(1.0));
    EXPECT_NEAR((both.pointToInertial(Vec(1, 0, 0)) - Vec(0, 0, 1)).norm(), 0, 1e-15);
    // rotatingMotion: right-handed about the axis.
    const RigidState turn = motionOf("rotatingMotion", "origin (1 0 0); axis (0 0 2); omega 1;")->at(std::acos(0.0));
    EXPECT_NEAR((turn.pointToInertial(Vec(2, 0, 0)) - Vec(1, 1, 0)).norm(), 0, 1e-15);
    const RigidState sway = motionOf("oscillatingLinearMotion", "amplitude (0 2 0); omega 1;")->at(std::asin(1.0));
    EXPECT_NEAR((sway.c - Vec(0, 2, 0)).norm(), 0, 1e-15);
}

TEST(SolidBodyMotion, AnOscillationShiftedByAQuarterPeriodIsACosine)
{
    const double omega = 4, quarter = std::acos(0.0) / omega;
    const auto motion = motionOf(
        "oscillatingLinearMotion", "amplitude (0.032 0 0); omega 4; phaseShift " + std::to_string(quarter) + ";"
    );
    for (const double t : {0.0, 0.2, 1.1})
    {
        const RigidState state = motion->at(t);
        EXPECT_NEAR(state.c.x(), 0.032 * std::cos(omega * t), 1e-7);
        EXPECT_NEAR(state.velocityAt(Vec::Zero()).x(), -0.032 * omega * std::sin(omega * t), 5e-7);
    }
}

// Public report P20: what liquid can meet does not depend on the frame that it is seen from.
TEST(SolidBodyMotion, OfATankThatTravelsHasTheSpeedsOfOneThatStands)
{
    const BoundingBox box(Vec(-0.2, -0.5, 0), Vec(0.2, 0.5, 0.2));
    const auto speedOf = [&](const std::string& name, const std::string& coeffs, bool restsInTank)
    { return motionOf(name, coeffs)->greatestSpeed(box, 100, 4000, restsInTank); };
    const std::string sway = "solidBodyMotionFunction oscillatingLinearMotion; amplitude (0.03 0 0); omega 5;";
    const std::string travel = "solidBodyMotionFunction linearMotion; velocity (20 3 0);";
    EXPECT_NEAR(speedOf("linearMotion", "velocity (20 0 0);", true), 0, 1e-12);
    EXPECT_NEAR(speedOf("linearMotion", "velocity (20 0 0);", false), 20, 1e-12) << "it sets off with 20 m/s";
    EXPECT_NEAR(speedOf("multiMotion", "a { " + sway + " }", true), 0.15, 1e-3);
    EXPECT_NEAR(
        speedOf("multiMotion", "a { " + travel + " } b { " + sway + " }", true),
        speedOf("multiMotion", "a { " + sway + " }", true), 1e-12
    );
    // A tank that gathers speed slowly: 0.1 m/s^2 over a metre, not 10 m/s.
    EXPECT_NEAR(
        speedOf(
            "oscillatingLinearMotion", "amplitude (0 0 0); omega 1; verticalShift polynomial (((0.05 0 0) (2 2 2)));",
            false
        ),
        std::sqrt(0.1), 1e-6
    );
}

TEST(SolidBodyMotion, MultiMotionAppliesTheLastFirst)
{
    // The tank turns about its own origin, then all that is carried by the sway.
    const RigidState state =
        motionOf(
            "multiMotion", "a { solidBodyMotionFunction rotatingMotion; rotatingMotionCoeffs { origin (0 0 0); axis "
                           "(0 0 1); omega 1; } } b { solidBodyMotionFunction linearMotion; linearMotionCoeffs { "
                           "velocity (1 0 0); } }"
        )
            ->at(std::acos(0.0));
    const double moved = std::acos(0.0);
    EXPECT_NEAR((state.pointToInertial(Vec::Zero()) - Vec(0, moved, 0)).norm(), 0, 1e-15);
}

/// A table of the roll 8 deg sin 4t and a surge, N samples up to 3 s.
std::string tableOf(int N)
{
    std::string text = std::to_string(N) + "\n(\n";
    char line[200];
    for (int i = 0; i < N; ++i)
    {
        const double t = 3.0 * i / (N - 1);
        std::snprintf(
            line, sizeof line, "(%.17g ((%.17g 0 0) (%.17g 0 0)))\n", t, 0.02 * std::sin(3 * t), 8 * std::sin(4 * t)
        );
        text += line;
    }
    return text + ")\n";
}

TEST(Tabulated6DoFMotion, ApproachesTheMotionItWasSampledFromAtThirdOrder)
{
    const fs::path folder = fs::temp_directory_path() / ("slosh.table." + std::to_string(::getpid()));
    const auto errorOf = [&](int N)
    {
        writeFile(folder / "constant/6DoF.dat", tableOf(N));
        const auto motion = motionOf(
            "tabulated6DoFMotion", "CofG (0 0 0.31); timeDataFileName \"$FOAM_CASE/constant/6DoF.dat\";", folder
        );
        EXPECT_DOUBLE_EQ(motion->lastTime(), 3);
        double error = 0;
        for (double t = 1; t < 2; t += 0.0137) // away from the ends, where a row is missing
        {
            const double angle = 8 * degree * std::sin(4 * t);
            const Mat R = Eigen::AngleAxisd(angle, Vec::UnitX()).toRotationMatrix();
            const Vec X(0, 0.46, 0);
            const Vec exact = Vec(0, 0, 0.31) + R * (X - Vec(0, 0, 0.31)) + Vec(0.02 * std::sin(3 * t), 0, 0);
            error = std::max(error, (motion->at(t).pointToInertial(X) - exact).norm());
        }
        return error;
    };
    const double order = std::log2(errorOf(31) / errorOf(61));
    EXPECT_NEAR(order, 3, 0.2);
    const auto motion =
        motionOf("tabulated6DoFMotion", "CofG (0 0 0); timeDataFileName \"constant/6DoF.dat\";", folder);
    EXPECT_THROW(motion->at(3.5), CaseError);
    fs::remove_all(folder);
}

TEST(SolidBodyMotion, OverAStepHasTheMomentumOfItsEndsAndIsTheInstantHalfWayToSecondOrder)
{
    const auto motion = motionOf("oscillatingRotatingMotion", "origin (0 0 0.31); amplitude (8 3 0); omega 4;");
    const auto apart = [&](double dt)
    {
        const RigidState mean = motion->over(1 - dt / 2, 1 + dt / 2), instant = motion->at(1);
        return (mean.accelerationAt(Vec(0, 0.46, 0)) - instant.accelerationAt(Vec(0, 0.46, 0))).norm();
    };
    EXPECT_NEAR(std::log2(apart(0.02) / apart(0.01)), 2, 0.02);

    Vec velocity = motion->at(0).velocity, omega = motion->at(0).omega;
    for (int n = 0; n < 10; ++n)
    {
        const RigidState mean = motion->over(0.1 * n, 0.1 * (n + 1));
        velocity += 0.1 * mean.acceleration;
        omega += 0.1 * mean.omegaDot;
    }
    EXPECT_LT((velocity - motion->at(1).velocity).norm(), 1e-14);
    EXPECT_LT((omega - motion->at(1).omega).norm(), 1e-14);
    EXPECT_EQ(motion->over(1, 1).acceleration, motion->at(1).acceleration);
}

/// The entries as the annotated dictionary has them.
std::string examplesOf(const Keys& keys)
{
    std::string text;
    for (const Key& key : keys)
    {
        const std::string value(key.example.empty() ? key.otherwise : key.example);
        text += std::string(key.name) + (key.entries == nullptr ? " " + value + "; " : " { " + value + " } ");
    }
    return text;
}

TEST(SolidBodyMotion, HasExamplesThatCanBeRead)
{
    for (const auto& choice : MotionFunction::choices())
    {
        const std::string name(choice.name);
        ASSERT_EQ(choice.entries().size(), 1u) << name;
        const Key coeffs = choice.entries().front();
        EXPECT_EQ(coeffs.name, name + "Coeffs");
        if (name != "tabulated6DoFMotion") // it needs a file
        {
            EXPECT_NO_THROW(motionOf(name, examplesOf(coeffs.entries()))) << name;
        }
    }
}

TEST(SolidBodyMotion, StandsWhereVersionsOfOpenFOAMHaveIt)
{
    const auto read = [](const std::string& text)
    { return SolidBodyMotion::read(Dictionary::parse(text, "constant/dynamicMeshDict"), ".")->description(); };
    const std::string function = "solidBodyMotionFunction linearMotion; ", beside = "velocity (0.1 0 0); ",
                      apart = "linearMotionCoeffs { " + beside + "} ", other = "SDACoeffs { } ";
    for (const std::string& coeffs : {beside, apart})
    {
        EXPECT_EQ(read(function + coeffs), "linearMotion: velocity (0.1 0 0) m/s");
        for (const std::string inner : {"solidBodyCoeffs", "solidBodyMotionCoeffs", "solidBodyMotionFvMeshCoeffs"})
        {
            const std::string open = inner + " { cellZone none; " + function + coeffs;
            EXPECT_EQ(read(open + "}"), "linearMotion: velocity (0.1 0 0) m/s");
            EXPECT_EQ(read(open + other + "}"), "linearMotion: velocity (0.1 0 0) m/s");
        }
        EXPECT_EQ(
            read("mover { type motionSolver; libs (a); motionSolver solidBody; " + function + coeffs + "}"),
            "linearMotion: velocity (0.1 0 0) m/s"
        );
    }
    EXPECT_NO_THROW(read("motionSolverLibs (a); solver solidBody; " + function + apart));
    EXPECT_THROW(read(function + apart + beside), CaseError);
    const std::string parts =
        "solidBodyMotionFunction multiMotion; a { " + function + beside + "} b { " + function + apart + "} ";
    EXPECT_NO_THROW(read(parts));
    EXPECT_NO_THROW(read("solidBodyCoeffs { " + parts + "}"));
}

/// What reading it is refused with.
std::string refusalOf(const std::string& text)
{
    try
    {
        SolidBodyMotion::read(Dictionary::parse(text, "constant/dynamicMeshDict"), ".");
    }
    catch (const CaseError& error)
    {
        return error.what();
    }
    return "not refused";
}

TEST(SolidBodyMotion, TellsOfCoefficientsOfAnotherMotionThatTheyAreNotUsed)
{
    const Dictionary dict = Dictionary::parse(
        "solidBodyMotionFunction linearMotion;\nlinearMotionCoeffs { velocity (0.1 0 0); }\n"
        "oscillatingLinearMotionCoeffs { amplitude (1 0 0); omega 2; }\nourOwnMotionCoeffs { }\n",
        "constant/dynamicMeshDict"
    );
    EXPECT_EQ(SolidBodyMotion::read(dict, ".")->description(), "linearMotion: velocity (0.1 0 0) m/s");
    EXPECT_EQ(
        dict.unusedEntries(), (std::vector<std::string>{
                                  "constant/dynamicMeshDict:3: oscillatingLinearMotionCoeffs",
                                  "constant/dynamicMeshDict:4: ourOwnMotionCoeffs"})
    );
}

TEST(SolidBodyMotion, RefusesAMisspeltEntryWhereverTheCoefficientsStand)
{
    const std::string motion = "solidBodyMotionFunction oscillatingLinearMotion;\n",
                      coeffs = "amplitude (0.01 0 0); omega 4;\nphaseShfit 0.3;\n",
                      wanted = "constant/dynamicMeshDict:3: unknown keyword 'phaseShfit'; did you mean "
                               "'phaseShift'?";
    EXPECT_EQ(refusalOf(motion + coeffs).substr(0, wanted.size()), wanted);
    EXPECT_EQ(refusalOf("mover { type motionSolver; " + motion + coeffs + "}").substr(0, wanted.size()), wanted);
    EXPECT_EQ(refusalOf("solidBodyCoeffs { " + motion + coeffs + "}").substr(0, wanted.size()), wanted);
    EXPECT_EQ(refusalOf(motion + "oscillatingLinearMotionCoeffs { " + coeffs + "}").substr(0, wanted.size()), wanted);
    EXPECT_EQ(
        refusalOf("solidBodyMotionFunction multiMotion; a { " + motion + coeffs + "}").substr(0, wanted.size()), wanted
    );
}

TEST(SolidBodyMotion, RefusesAZoneThatMovesAlone)
{
    const std::string motion = "solidBodyMotionFunction linearMotion; velocity (0.1 0 0); ",
                      wanted = "constant/dynamicMeshDict:2: cellZone is rotor: OpenFOAM moves these cells "
                               "alone";
    for (const std::string holder : {"", "solidBodyCoeffs { ", "mover { type motionSolver; "})
    {
        const std::string end = holder.empty() ? "" : "}";
        EXPECT_EQ(refusalOf(holder + motion + "\ncellZone rotor;" + end).substr(0, wanted.size()), wanted);
        EXPECT_EQ(refusalOf(holder + motion + "cellZone all; cellSet \"none\";" + end), "not refused");
    }
    EXPECT_NE(refusalOf(motion + "cellSet c;").find(": cellSet is c: "), std::string::npos);
}

TEST(SolidBodyMotion, NamesTheMoversItKnows)
{
    const std::string refusal = refusalOf("mover { type interpolator; }");
    EXPECT_NE(refusal.find("unknown mover type 'interpolator'"), std::string::npos) << refusal;
    EXPECT_NE(refusal.find("Valid mover types: motionSolver"), std::string::npos) << refusal;
}

TEST(SolidBodyMotion, RefusesWhatItDoesNotKnow)
{
    EXPECT_THROW(motionOf("oscilatingRotatingMotion", "origin (0 0 0); amplitude (8 0 0); omega 4;"), CaseError);
    EXPECT_THROW(motionOf("oscillatingRotatingMotion", "origin (0 0 0); amplitude (8 0 0);"), CaseError);
    EXPECT_THROW(
        motionOf("oscillatingRotatingMotion", "origin (0 0 0); amplitude (8 0 0); omega 4; phase 1;"), CaseError
    );
    EXPECT_THROW(motionOf("rotatingMotion", "origin (0 0 0); axis (0 0 0); omega 4;"), CaseError);
    EXPECT_THROW(motionOf("tabulated6DoFMotion", "CofG (0 0 0); timeDataFileName \"constant/none.dat\";"), CaseError);
}

} // namespace
} // namespace slosh
