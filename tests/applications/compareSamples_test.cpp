// SPDX-License-Identifier: GPL-3.0-or-later
// compareSamples as a user runs it: figures whose answers are known, exact solutions of the case, bad input.
#include "CaseDirectory.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <map>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

namespace slosh
{
namespace
{

/// Columns of comparisons.tsv by description.
std::map<std::string, std::vector<std::string>> rowsOf(const CaseDirectory& theCase)
{
    std::map<std::string, std::vector<std::string>> rows;
    std::istringstream lines(theCase.text("postProcessing/compareSamples/comparisons.tsv"));
    for (std::string line; std::getline(lines, line);)
    {
        std::vector<std::string> columns;
        std::istringstream cells(line);
        for (std::string cell; std::getline(cells, cell, '\t');)
        {
            columns.push_back(cell);
        }
        rows[columns.at(0)] = columns;
    }
    return rows;
}

class CompareSamples : public testing::Test
{
protected:
    CompareSamples()
    {
        std::ostringstream line, sine;
        line << std::setprecision(12) << "# Time p\n";
        sine << std::setprecision(12) << "# Time p\n";
        for (int k = 0; k <= 400; ++k)
        {
            const double t = 0.01 * k;
            line << t << " " << 2 * t << "\n";
            sine << t << " " << 3 + 5 * std::sin(2 * std::acos(-1.0) * t) << "\n";
        }
        case_.write("postProcessing/line/0/p", line.str());
        case_.write("postProcessing/sine/0/p", sine.str());
    }

    Ended compare(const std::string& comparisons) const
    {
        case_.write("system/comparisonsDict", comparisons);
        return case_.run("compareSamples");
    }

    void expectRefused(const std::string& comparisons, const std::vector<std::string>& fragments) const
    {
        const Ended ended = compare(comparisons);
        EXPECT_EQ(ended.status, 1) << comparisons;
        for (const auto& fragment : fragments)
        {
            EXPECT_NE(ended.err.find(fragment), std::string::npos) << fragment << " is not in\n" << ended.err;
        }
        EXPECT_EQ(case_.tree().count("postProcessing/compareSamples/comparisons.tsv"), 0u);
    }

    CaseDirectory case_;
};

TEST_F(CompareSamples, TabulatesFiguresErrorsAndSources)
{
    const Ended ended = compare(R"(
        mean { samples line/p; column 1; quantity mean; unit Pa;
               reference { type stated; value 5; uncertainty 0.5; source "a book"; } }
        peak { description "highest"; samples sine/p; column 1; quantity meanPeak; period 1;
               reference { type stated; range (7 9); } }
        outside { samples sine/p; column 1; scale 2; offset 1; quantity maximum; reference { type stated; range (1 7); } }
        alone { samples line/p; column 1; timeStart 1; timeEnd 2; quantity range; reference { type none; } })");
    ASSERT_EQ(ended.status, 0) << ended.err;
    auto rows = rowsOf(case_);
    EXPECT_EQ(rows["mean"], (std::vector<std::string>{"mean", "4 Pa", "5 +- 0.5 Pa", "-20 %", "a book"}));
    EXPECT_EQ(rows["highest"][1].substr(0, 1), "8");
    EXPECT_EQ(rows["highest"][3], "inside");
    EXPECT_EQ(rows["outside"][3], "10 outside"); // 2*8 + 1 - 7
    EXPECT_EQ(rows["alone"][1], "2");
    EXPECT_EQ(rows["alone"][3], "-");
    // The same for programs: numbers under the names of the comparisons.
    const std::string numbers = case_.text("postProcessing/compareSamples/comparisons.dat");
    EXPECT_EQ(
        std::regex_replace(numbers, std::regex("(peak 8 0 nan) [-+.e0-9]+"), "$1 <rounding>"),
        "# name figure error reference uncertainty referenceUncertainty count\nmean 4 -0.2 5 nan 0.5 0\n"
        "peak 8 0 nan <rounding> nan 4\noutside 17 10 nan nan nan 0\nalone 2 nan nan nan nan 0\n"
    );
}

TEST_F(CompareSamples, TakesOtherSamplesAsReferenceAndStatesRatios)
{
    const Ended ended = compare(R"(
        half { samples line/p; column 1; quantity maximum; ratio yes; stated 0.25;
               reference { type samples; samples line/p; column 1; scale 4; } }
        same { samples sine/p; column 1; quantity difference; reference { type samples; samples sine/p; column 1; } }
        early { samples line/p; column 1; timeStart 2; quantity mean;
                reference { type samples; samples line/p; column 1; timeEnd 2; } })");
    ASSERT_EQ(ended.status, 0) << ended.err;
    auto rows = rowsOf(case_);
    EXPECT_EQ(rows["half"][1], "0.25");
    EXPECT_EQ(rows["half"][3], "0");
    EXPECT_EQ(rows["same"][1], "0 %");
    EXPECT_EQ(rows["early"][3], "200 %"); // 6 against 2
}

TEST_F(CompareSamples, HoldsThePeakOfTheMovingAverageAgainstTheStatedOne)
{
    // A triangle of 1000 Pa, 0.2 s wide: its mean over 0.1 s about the top is 750 Pa.
    std::ostringstream samples;
    for (int k = 0; k <= 100; ++k)
    {
        samples << 0.01 * k << " " << 1000 * std::max(0.0, 1 - std::abs(k - 50) / 10.0) << "\n";
    }
    case_.write("postProcessing/triangle/0/p", samples.str());
    const std::string peak =
        "samples triangle/p; column 1; unit Pa; quantity maximum; reference { type stated; value 500; } ";
    ASSERT_EQ(compare("raw { " + peak + "} filtered { " + peak + " filter 0.1; }").status, 0);
    auto rows = rowsOf(case_);
    ASSERT_EQ(
        compare("both { samples triangle/p; column 1; filter 0.1; quantity difference; "
                "reference { type samples; samples triangle/p; column 1; filter 0.1; } }")
            .status,
        0
    );
    EXPECT_EQ(rowsOf(case_)["both"][1], "0 %");
    EXPECT_EQ(rows["raw"][1], "1000 Pa");
    EXPECT_EQ(rows["raw"][3], "100 %");
    EXPECT_EQ(rows["filtered"][1], "750 Pa");
    EXPECT_EQ(rows["filtered"][3], "50 %");
}

TEST_F(CompareSamples, HoldsTheLargestMeanOfAWindowAgainstThatOfARecord)
{
    // Triangles of 1000 Pa and 800 Pa, 0.2 s and 0.4 s wide, the record at other instants than the samples.
    std::ostringstream samples, record;
    for (int k = 0; k <= 100; ++k)
    {
        samples << 0.01 * k << " " << 1000 * std::max(0.0, 1 - std::abs(k - 50) / 10.0) << "\n";
    }
    record << "t,p\n0,0\n0.3,0\n0.47,0.68\n0.5,0.8\n0.61,0.36\n0.7,0\n1,0\n";
    case_.write("postProcessing/triangle/0/p", samples.str());
    case_.write("measured/record.csv", record.str());
    const std::string mean = "samples triangle/p; column 1; unit Pa; quantity largestMean; window 0.1; ";
    case_.write(
        "system/comparisonsDict", "measured { " + mean +
                                      "reference { type measured; file record.csv; column 1; scale 1000; } }\n" +
                                      "early { " + mean + "timeEnd 0.45; reference { type stated; value 100; } }"
    );
    ASSERT_EQ(case_.run("compareSamples", "SLOSH_MEASURED=measured").status, 0);
    auto rows = rowsOf(case_);
    EXPECT_EQ(rows["measured"][1], "750 Pa");
    EXPECT_EQ(rows["measured"][2], "700 Pa");
    EXPECT_EQ(rows["early"][1], "125 Pa"); // a triangle of 500 Pa, half as long as the window
}

TEST_F(CompareSamples, RefusesAWindowLongerThanTheSamplesAndNone)
{
    expectRefused(
        "a { samples line/p; column 1; quantity largestMean; window 5; reference { type none; } }",
        {"the samples in the requested time span last 4 s, less than the window of 5 s"}
    );
    expectRefused("a { samples line/p; column 1; quantity largestMean; reference { type none; } }", {"'window'"});
}

TEST_F(CompareSamples, StatesHowLateAnInstantIsNotWhichShareOfTheClock)
{
    ASSERT_EQ(
        compare("rise { samples line/p; column 1; unit s; quantity firstTimeAbove; level 3.25; "
                "reference { type stated; value 1.5; } }")
            .status,
        0
    );
    EXPECT_EQ(rowsOf(case_)["rise"][1], "1.625 s");
    EXPECT_EQ(rowsOf(case_)["rise"][3], "0.125 s");
}

TEST_F(CompareSamples, SaysNoneOfARiseThatDoesNotComeAndHoldsNoBoundWithIt)
{
    const std::string never = "samples line/p; column 1; unit s; quantity firstTimeAbove; level 1e6; ";
    const std::string rise = "rise { " + never + "reference { type stated; value 1.5; } }";
    const Ended bound = compare("rise { " + never + "bound 1; reference { type stated; value 1.5; } }");
    EXPECT_EQ(bound.status, 1);
    EXPECT_NE(bound.err.find("rise: none against 1.5 s; the bound is 1"), std::string::npos) << bound.err;
    ASSERT_EQ(compare(rise).status, 0);
    auto rows = rowsOf(case_);
    EXPECT_EQ(rows["rise"][1], "none");
    EXPECT_EQ(rows["rise"][2], "1.5 s");
    EXPECT_EQ(rows["rise"][3], "-");
}

TEST_F(CompareSamples, KnowsTheHydrostaticStartOfLinearTheory)
{
    // At t = 0 nothing has moved yet: the pressure is rho0 g d at any point, and the surface is where it was.
    case_.write("postProcessing/probe/0/p", "0 392.4\n1e-9 392.4\n");
    const Ended ended = compare(R"(
        p { samples probe/p; column 1; quantity mean;
            reference { type linearSloshing; field p; location (0 0 0.06); start withTank; } }
        eta { samples probe/p; column 1; quantity mean;
              reference { type linearSloshing; field eta; location (0 0.05 0); start withTank; } })");
    ASSERT_EQ(ended.status, 0) << ended.err;
    auto rows = rowsOf(case_);
    // In the middle of the tank, where the odd modes have their node; rolling itself presses rho theta'' x y, 0 there.
    EXPECT_NEAR(std::stod(rows["p"][2]), 1000 * 9.81 * 0.04, 0.1);
    EXPECT_NEAR(std::stod(rows["eta"][2]), 0, 1e-6);
}

TEST_F(CompareSamples, KnowsSwayOfFiniteAmplitudeWhichTendsToTheLinearOne)
{
    // the largest difference of the two at the wall, over the largest linear elevation
    const auto apart = [&](const std::string& amplitude)
    {
        case_.write(
            "constant/dynamicMeshDict", "solidBodyMotionFunction oscillatingLinearMotion;\n"
                                        "oscillatingLinearMotionCoeffs { amplitude (0 " +
                                            amplitude + " 0); omega 9; }\n"
        );
        const std::string sway = "samples line/p; column 1; timeEnd 2; quantity maximum; reference { field eta; "
                                 "location (0 0.1 0.1); start atRest; type ";
        const Ended ended =
            compare("linear { " + sway + "linearSloshing; } } nonlinear { " + sway + "nonlinearSloshing; order 4; } }");
        EXPECT_EQ(ended.status, 0) << ended.err;
        const auto elevations = [&](const std::string& name)
        {
            std::istringstream lines(case_.text("postProcessing/compareSamples/" + name + ".dat"));
            std::vector<double> values;
            for (std::string line; std::getline(lines, line);)
            {
                double time = 0, sample = 0, reference = 0;
                if (std::istringstream(line) >> time >> sample >> reference)
                {
                    values.push_back(reference);
                }
            }
            return values;
        };
        const auto linear = elevations("linear"), nonlinear = elevations("nonlinear");
        EXPECT_EQ(linear.size(), 201u);
        EXPECT_EQ(nonlinear.size(), 201u);
        double difference = 0, highest = 0;
        for (std::size_t i = 0; i < std::min(linear.size(), nonlinear.size()); ++i)
        {
            difference = std::max(difference, std::abs(linear[i] - nonlinear[i]));
            highest = std::max(highest, std::abs(linear[i]));
        }
        return difference / highest;
    };
    EXPECT_LT(apart("1e-5"), 0.02); // the walls' part beyond 64 modes
    EXPECT_GT(apart("2e-3"), 0.05);
}

TEST_F(CompareSamples, RefusesNonlinearFlowWhereItIsNotKnown)
{
    const auto one = [](const std::string& keys)
    {
        return "one { samples line/p; column 1; quantity maximum; reference { type nonlinearSloshing; location (0 0.1 "
               "0.1); " +
               keys + " } }";
    };
    expectRefused(one("field eta;"), {"expected a swaying tank"}); // it rolls
    expectRefused(one("field p;"), {"Valid", "eta"});
    expectRefused(one("field eta; modes 0;"), {"modes"});
    case_.write(
        "constant/dynamicMeshDict", "solidBodyMotionFunction oscillatingLinearMotion;\n"
                                    "oscillatingLinearMotionCoeffs { amplitude (0 0.05 0); omega 12; }\n"
    );
    expectRefused(one("field eta;"), {"steeper than 45 degrees at t = "});
}

TEST_F(CompareSamples, LeavesOutVisiblyWhatNobodyHasMeasuredHere)
{
    const std::string measured =
        "m { samples line/p; column 1; quantity maximum; reference { type measured; file none.csv; column 1; } }";
    const Ended ended = compare(measured);
    ASSERT_EQ(ended.status, 0) << ended.err;
    EXPECT_EQ(rowsOf(case_)["m"].at(2).rfind("not compared: none.csv", 0), 0u);
}

TEST_F(CompareSamples, ReadsAMeasuredRecordWithItsBandAndScales)
{
    case_.write("records/r.csv", "# a record\nt_ms,median,low,high\n0,0,-1,0.5\n4000,4,3,4.5\n");
    case_.write("system/comparisonsDict", R"(
        inside { samples line/p; column 1; quantity shareInside;
                 reference { type measured; file r.csv; column 1; lowColumn 2; highColumn 3; timeScale 1e-3; scale 2; } }
        far { samples line/p; column 1; quantity difference;
              reference { type measured; file r.csv; column 1; timeScale 1e-3; scale 2; } })");
    const Ended ended = case_.run("compareSamples", "SLOSH_MEASURED=records");
    ASSERT_EQ(ended.status, 0) << ended.err;
    auto rows = rowsOf(case_);
    EXPECT_EQ(rows["inside"][1], "100 %"); // 2 t between 2 t - 2 and 2 t + 1
    EXPECT_EQ(rows["far"][1], "0 %");
}

TEST_F(CompareSamples, EndsWithStatusOneWhereAnErrorIsBeyondItsBound)
{
    const std::string both = R"(
        near { samples line/p; column 1; quantity mean; bound 0.21; reference { type stated; value 5; } }
        far { samples line/p; column 1; quantity mean; bound 0.19; reference { type stated; value 5; } })";
    const Ended ended = compare(both);
    EXPECT_EQ(ended.status, 1);
    EXPECT_NE(ended.err.find("out of bounds:\n    far: 4 differs from 5 by -0.2; the bound is 0.19"), std::string::npos)
        << ended.err;
    EXPECT_EQ(rowsOf(case_).size(), 3u); // the table is there all the same: header and two rows
    EXPECT_EQ(case_.run("compareSamples -only near").status, 0);
    EXPECT_EQ(rowsOf(case_).size(), 2u);
    EXPECT_NE(case_.run("compareSamples -only neer").err.find("did you mean 'near'"), std::string::npos);
}

TEST_F(CompareSamples, RefusesWhatItCannotCompare)
{
    const auto one = [](const std::string& keys) { return "one { samples line/p; column 1; " + keys + " }"; };
    const std::string stated = "reference { type stated; value 1; }";
    expectRefused(one("quantity maximun; " + stated), {"maximun", "did you mean 'maximum'", "comparison one"});
    expectRefused(one("quantity maximum; refrence { }"), {"reference"});
    expectRefused(one("quantity maximum; reference { type state; value 1; }"), {"did you mean 'stated'"});
    expectRefused(one("quantity maximum; colour 3; " + stated), {"colour"});
    expectRefused(one("quantity difference; " + stated), {"is not a series"});
    expectRefused(one("quantity shareInside; " + stated), {"no lowColumn"});
    expectRefused(one("quantity meanPeak; period 9; " + stated), {"less than the period"});
    expectRefused(one("quantity maximum; timeStart 9; " + stated), {"no sample between"});
    expectRefused("one { samples none/p; column 1; quantity mean; " + stated + " }", {"has the case been run?"});
    expectRefused("one { samples line/p; column 7; quantity mean; " + stated + " }", {"column 7"});
    EXPECT_EQ(case_.run("compareSamples -dict system/none").status, 1);
    case_.write(
        "constant/tankProperties", "FoamFile { } type prism; plane yz; section yz; extent (-0.5 0.5); fillDepth "
                                   "0.1; polygon ((-0.05 0) (0.05 0) (0.1 0.05) (0.1 0.15) (-0.1 0.15));"
    );
    expectRefused(
        one("quantity maximum; reference { type linearSloshing; field eta; location (0 0 0.1); }"),
        {"type is linearSloshing for liquid in a"}
    );
}

} // namespace
} // namespace slosh
