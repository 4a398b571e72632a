// SPDX-License-Identifier: GPL-3.0-or-later
#include "motion/Function1.hpp"

#include "base/CaseError.hpp"
#include "base/writeFile.hpp"
#include "motion/SolidBodyMotion.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>
#include <unistd.h>

namespace slosh
{
namespace
{

constexpr double pi = std::numbers::pi;
constexpr Key f{.name = "f"};

std::unique_ptr<Function1>
functionOf(const std::string& entries, bool isVector = false, const std::string& folder = ".")
{
    return readFunction1(Dictionary::parse(entries, "constant/dynamicMeshDict"), f, isVector, folder);
}

/// Entries, the value at 0.3 s by its formula.
struct Example
{
    std::string entries;
    double value;
};

const std::vector<Example>& examples()
{
    static const std::vector<Example> all = {
        {"f 4;", 4},
        {"f [0 0 0 0 0 0 0] 4;", 4},
        {"f constant 4;", 4},
        {"f { type constant; value 4; }", 4},
        {"f polynomial ((2 0) (3 1) (1 3));", 2 + 0.9 + 0.027},
        {"f { type polynomial; coeffs ((2 2)); }", 0.18},
        {"f table ((0 1) (0.2 3) (0.6 1));", 2.5},
        {"f table 3((0 1) (0.2 3) (0.6 1));", 2.5},
        {"f { type table; values ((0.4 7) (1 9)); }", 7},
        {"f table; fCoeffs { values ((0 1) (0.2 3)); outOfBounds repeat; }", 2},
        {"f sine; fCoeffs { frequency 0.5; amplitude 2; t0 0.1; scale 3; level 1; }", 1 + 6 * std::sin(pi * 0.2)},
        {"f { type cosine; frequency 0.5; amplitude 2; }", 2 * std::cos(pi * 0.3)},
        {"f { type square; frequency 1; amplitude 2; markSpace 0.25; level 0.5; }", -1.5},
        {"f { type square; frequency 1; amplitude 2; }", 2},
        {"f { type linearRamp; start 0.1; duration 0.5; }", 0.4},
        {"f { type quadraticRamp; start 0.1; duration 0.5; }", 0.16},
        {"f { type halfCosineRamp; duration 0.5; }", (1 - std::cos(pi * 0.6)) / 2},
        {"f { type quarterCosineRamp; duration 0.5; }", 1 - std::cos(pi * 0.3)},
        {"f { type quarterSineRamp; duration 0.5; }", std::sin(pi * 0.3)},
        {"f { type linearRamp; start 1; duration 1; }", 0},
        {"f { type scale; scale { type linearRamp; duration 0.6; } value 5; }", 2.5},
        {"f { type scale; scale 3; value table ((0 1) (0.6 2)); }", 4.5}};
    return all;
}

TEST(Function1, HasTheValueOfItsFormulaItsDerivativesAndItsIntegral)
{
    for (const auto& [entries, value] : examples())
    {
        SCOPED_TRACE(entries);
        const auto function = functionOf(entries);
        const double t = 0.3, h = 1e-4;
        EXPECT_NEAR(function->scalarAt(t).f, value, 1e-14);
        for (const double at : {0.25, 0.3, 1.3})
        {
            const auto x = [&](double time) { return function->scalarAt(time).f; };
            EXPECT_NEAR(function->scalarAt(at).d, (x(at + h) - x(at - h)) / (2 * h), 1e-6);
            EXPECT_NEAR(function->scalarAt(at).dd, (x(at + h) - 2 * x(at) + x(at - h)) / (h * h), 1e-5);
        }
        // By the midpoint rule, which is off by half a part at a jump.
        constexpr int parts = 20000;
        double sum = 0;
        for (int k = 0; k < parts; ++k)
        {
            sum += function->scalarAt(1.3 * (k + 0.5) / parts).f * 1.3 / parts;
        }
        ASSERT_TRUE(function->integral(1.3));
        EXPECT_NEAR(*function->integral(1.3), sum, 5e-4);
        EXPECT_EQ(*function->integral(0), 0);
    }
}

TEST(Function1, IsTriedHereInEveryForm)
{
    std::set<std::string> tried = {"tableFile", "csvFile"}; // below: they need a file
    for (const Function1::Choice& choice : Function1::choices())
    {
        for (const Example& example : examples())
        {
            if (example.entries.find(std::string(choice.name)) != std::string::npos)
            {
                tried.emplace(choice.name);
            }
        }
        EXPECT_EQ(tried.count(std::string(choice.name)), 1U) << choice.name;
    }
}

TEST(Function1, OfVectorsHasThreeComponents)
{
    const auto table = functionOf("f table ((0 (1 2 3)) (2 (3 2 1)));", true);
    EXPECT_EQ(table->at(1)[0].f, 2);
    EXPECT_EQ(table->at(1)[1].d, 0);
    EXPECT_EQ(table->at(1)[2].d, -1);
    const auto wave = functionOf("f { type sine; frequency 1; scale (1 2 3); level (4 5 6); }", true);
    EXPECT_NEAR(wave->at(0.25)[2].f, 9, 1e-14);
    EXPECT_EQ(functionOf("f (1 2 3);", true)->description(), "(1 2 3)");
}

TEST(Function1, ReadsFilesOfTheCase)
{
    const std::filesystem::path folder =
        std::filesystem::temp_directory_path() / ("slosh.function1." + std::to_string(::getpid()));
    writeFile(folder / "constant/omega", "2\n(\n(0 1)\n(2 5)\n)\n");
    writeFile(folder / "constant/omega.csv", "a header\n9; 0; 1\n9; 2; 5\n");
    for (const std::string entries :
         {"f { type tableFile; file \"$FOAM_CASE/constant/omega\"; }",
          "f csvFile; fCoeffs { file \"<constant>/omega.csv\"; nHeaderLine 1; refColumn 1; componentColumns (2); "
          "separator "
          "\";\"; }"})
    {
        const auto function = functionOf(entries, false, folder.string());
        EXPECT_EQ(function->scalarAt(1).f, 3) << entries;
        EXPECT_EQ(*function->integral(2), 6) << entries;
    }
    writeFile(folder / "constant/omega.csv", "0, 1\n2, five\n");
    try
    {
        functionOf("f { type csvFile; file \"constant/omega.csv\"; componentColumns (1); }", false, folder.string());
        FAIL();
    }
    catch (const CaseError& error)
    {
        EXPECT_NE(std::string(error.what()).find("constant/omega.csv:2: "), std::string::npos) << error.what();
    }
    std::filesystem::remove_all(folder);
}

TEST(Function1, RefusesWhatItCannotRead)
{
    for (const std::string entries :
         {"f tabel ((0 1));", "f table ((0 1) (0 2));", "f table ((0 1) (1));", "f table ();", "f (1 2 3);",
          "f { type sine; amplitude 2; }", "f { type sine; frequency 2; amplitud 1; }", "f { type linearRamp; }",
          "f { type table; values ((0 1) (1 2)); outOfBounds never; }", "f polynomial ((1 -1));", "f constant;",
          "g 4;"})
    {
        EXPECT_THROW(functionOf(entries), CaseError) << entries;
    }
    const auto ends = functionOf("f { type table; values ((0 1) (1 2)); outOfBounds error; }");
    EXPECT_EQ(ends->lastTime(), 1);
    EXPECT_THROW(ends->at(1.1), CaseError);
}

// Public reports R4 and R7: what OpenFOAM makes of these dictionaries.
TEST(Function1, MovesTheTankAsOpenFOAMDoes)
{
    const auto turns = SolidBodyMotion::read(
        Dictionary::parse(
            "solidBodyMotionFunction rotatingMotion; rotatingMotionCoeffs { origin (0 0 0.1); axis (0 1 0); omega "
            "table "
            "((0 0) (0.02 25) (100 25)); }",
            "constant/dynamicMeshDict"
        ),
        "."
    );
    const auto angle = [&](double t) { return std::atan2(turns->at(t).R(0, 2), turns->at(t).R(0, 0)); };
    EXPECT_NEAR(angle(0.02), 0.25, 1e-12);
    EXPECT_NEAR(angle(0.04), 0.75, 1e-12);
    const auto swings = SolidBodyMotion::read(
        Dictionary::parse(
            "solidBodyMotionFunction oscillatingLinearMotion; oscillatingLinearMotionCoeffs { h 0.0125; amplitude (-$h "
            "0 0); omega ${{ 2*pi() }}; phaseShift 0.25; verticalShift ($h 0 0); }",
            "constant/dynamicMeshDict"
        ),
        "."
    );
    for (const double t : {0.0, 0.25, 0.5, 0.7})
    {
        EXPECT_NEAR(swings->at(t).c[0], 0.0125 * (1 - std::cos(2 * pi * t)), 1e-16);
        EXPECT_NEAR(swings->at(t).velocity[0], 0.0125 * 2 * pi * std::sin(2 * pi * t), 1e-15);
    }
}

} // namespace
} // namespace slosh
