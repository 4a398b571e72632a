// SPDX-License-Identifier: GPL-3.0-or-later
// Ensembles of sloshSweep: means over members beside a reference, held against the table of the cases.
#include "SweepCase.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace slosh
{
namespace
{

const std::string amplitude = "amplitude { file \"constant/dynamicMeshDict\"; entry "
                              "oscillatingRotatingMotionCoeffs.amplitude; direction (1 0 0); values (8 8.8 9.6); }";
const std::string depth = "depth { file \"constant/tankProperties\"; entry fillDepth; values (0.06 0.1); unit m; }";

std::string peak(const std::string& reference)
{
    return "peak { samples \"pressure/p\"; column 1; quantity maximum; unit Pa; " + reference + " }";
}

/// Mean and standard deviation of three values.
std::pair<double, double> momentsOf(double a, double b, double c)
{
    const double mean = (a + b + c) / 3;
    const auto square = [&](double x) { return (x - mean) * (x - mean); };
    return {mean, std::sqrt((square(a) + square(b) + square(c)) / 2)};
}

class SweptEnsemble : public testing::Test
{
protected:
    SweepTable ensembles() const { return tableOf(case_, "ensemble.tsv"); }

    void expectRefused(const std::string& entry, const std::vector<std::string>& fragments) const
    {
        case_.writeSweep(depth + amplitude, peak(""), entry);
        const Ended ended = case_.run("sloshSweep");
        EXPECT_EQ(ended.status, 1) << entry;
        for (const auto& fragment : fragments)
        {
            EXPECT_NE(ended.err.find(fragment), std::string::npos) << fragment << " is not in\n" << ended.err;
        }
    }

    const SweepCase case_;
};

TEST_F(SweptEnsemble, HasMeanAndDeviationOfItsMembersBesideTheReference)
{
    case_.writeSweep(
        depth + amplitude, peak("reference { type stated; value 1000; uncertainty 10; source \"102 runs\"; }"),
        "ensemble (amplitude);"
    );
    const std::string out = case_.succeed("sloshSweep");
    const auto rows = case_.table();
    auto ensembles = this->ensembles();
    ASSERT_EQ(rows.size(), 6u);
    ASSERT_EQ(ensembles.size(), 2u);
    for (std::size_t k = 0; k < 2; ++k)
    {
        const auto p = [&](std::size_t i) { return std::stod(rows[3 * k + i].at("peak [Pa]")); };
        ASSERT_NE(p(0), p(2));
        const auto [mean, deviation] = momentsOf(p(0), p(1), p(2));
        auto& row = ensembles[k];
        const auto figure = [&](const std::string& name) { return std::stod(row.at(name)); };
        EXPECT_EQ(row["# depth [m]"], k == 0 ? "0.06" : "0.1");
        EXPECT_EQ(row["result"], "peak");
        EXPECT_EQ(row["unit"], "Pa");
        EXPECT_EQ(row["members"], "3");
        EXPECT_EQ(row["missing"], "0");
        // The table of the cases has six digits.
        EXPECT_NEAR(figure("mean"), mean, 1e-5 * mean);
        EXPECT_NEAR(figure("standard deviation"), deviation, 1e-5 * mean);
        EXPECT_NEAR(figure("standard error"), deviation / std::sqrt(3), 1e-5 * mean);
        EXPECT_EQ(row["reference"], "1000");
        EXPECT_EQ(row["reference uncertainty"], "10");
        EXPECT_NEAR(figure("difference"), mean - 1000, 1e-5 * mean);
        const double combined = std::hypot(deviation / std::sqrt(3), 10);
        EXPECT_NEAR(figure("combined uncertainty"), combined, 1e-5 * mean);
        // 0.1 m deep the pressure 0.05 m above the bottom is about half a kPa, 0.06 m deep a tenth of one.
        EXPECT_EQ(row["within"], "no");
        EXPECT_EQ(row["source"], "102 runs");
    }
    EXPECT_NE(out.find("depth=0.06, peak: "), std::string::npos) << out;
    EXPECT_NE(out.find(" of 3 members; reference 1000 +- 10 Pa (102 runs); difference -"), std::string::npos) << out;
    EXPECT_NE(out.find(", reference's 10): outside\n"), std::string::npos) << out;
}

TEST_F(SweptEnsemble, IsAllCasesAndKnowsWhatIsMissing)
{
    case_.writeSweep(amplitude, peak("reference { type stated; value 500; uncertainty 1000; }"), "ensemble yes;");
    case_.succeed("sloshSweep -only 1");
    case_.succeed("sloshSweep -only 3");
    EXPECT_EQ(case_.run("sloshSweep -collect").status, 1);
    auto row = ensembles().at(0);
    EXPECT_EQ(row["# result"], "peak");
    EXPECT_EQ(row["members"], "2");
    EXPECT_EQ(row["missing"], "1");
    EXPECT_EQ(row["within"], "yes");
    case_.succeed("sloshSweep");
    row = ensembles().at(0);
    EXPECT_EQ(row["members"], "3");
    EXPECT_EQ(row["missing"], "0");
}

TEST_F(SweptEnsemble, GivesNoVerdictWhereNoUncertaintyIsKnown)
{
    case_.writeSweep(
        amplitude,
        peak("reference { type stated; value 500; }") + "level { samples \"gauges/height.dat\"; "
                                                        "column 1; quantity mean; }",
        "ensemble yes;"
    );
    case_.succeed("sloshSweep");
    auto rows = ensembles();
    ASSERT_EQ(rows.size(), 2u);
    EXPECT_EQ(rows[0]["reference"], "500");
    EXPECT_EQ(rows[0]["combined uncertainty"], "nan");
    EXPECT_EQ(rows[0]["within"], "nan");
    EXPECT_EQ(rows[1]["reference"], "nan");
    EXPECT_EQ(rows[1]["source"], "-");
    // No ensemble any more, no table of one.
    case_.write("system/sweepDict", case_.text("system/sweepDict") + "ensemble no;\n");
    EXPECT_EQ(case_.succeed("sloshSweep").find("ensemble.tsv"), std::string::npos);
}

TEST_F(SweptEnsemble, NamesMembersThatAreTheSameRun)
{
    case_.writeSweep(
        "spacing { file \"system/blockParticlesDict\"; entry particleSpacing; values (0.02 0.01999 0.025); }", peak(""),
        "ensemble (spacing);"
    );
    const std::string out = case_.succeed("sloshSweep");
    EXPECT_NE(out.find("spacing=0.01999 and spacing=0.02 have the same results to the last digit"), std::string::npos)
        << out;
    EXPECT_EQ(out.find("spacing=0.025 and"), std::string::npos) << out;
}

TEST_F(SweptEnsemble, IsRefusedWhereItMeansNothing)
{
    expectRefused("ensemble (amplitud);", {"unknown axis 'amplitud'", "did you mean 'amplitude'?"});
    expectRefused("ensemble ();", {"ensemble is empty; expected the name of an axis"});
    expectRefused("ensemble maybe;", {"ensemble is maybe", "maybe"});
    case_.writeSweep(amplitude, "", "ensemble yes;");
    const Ended ended = case_.run("sloshSweep");
    EXPECT_EQ(ended.status, 1);
    EXPECT_NE(ended.err.find("ensemble is set without results"), std::string::npos) << ended.err;
}

} // namespace
} // namespace slosh
