// SPDX-License-Identifier: GPL-3.0-or-later
// peakStatistics as a user runs it: peaks of known triangles, and what can be wrong with its dictionary.
#include "CaseDirectory.hpp"
#include "samples.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

namespace slosh
{
namespace
{

namespace fs = std::filesystem;

/// Triangles from zero at whole seconds from `first` on, rising in 0.25 s and falling in 0.25 s; the second column is
/// twice the first.
std::string triangles(int first, const std::vector<double>& heights)
{
    std::ostringstream text;
    text << "# Probe 0 (0 0 0)\n#       Probe             0             1\n#        Time\n";
    for (std::size_t k = 0; k < heights.size(); ++k)
    {
        const double t = first + static_cast<double>(k);
        text << t - 0.25 << " 0 0\n" << t << " " << heights[k] << " " << 2 * heights[k] << "\n" << t + 0.25 << " 0 0\n";
    }
    return text.str();
}

/// Peaks of 600 to 1200 at 1 to 7 s, 300 at 8 s; the restart replaces what went wrong after 4.5 s.
class PeakStatistics : public testing::Test
{
protected:
    void SetUp() override
    {
        case_.write("postProcessing/x/0/p", triangles(1, {600, 700, 800, 900, 5000, 5000}));
        case_.write("postProcessing/x/4.5/p", triangles(5, {1000, 1100, 1200, 300}));
        case_.write(
            "system/peakStatisticsDict", "left\n{\n    samples x/p;\n    threshold 500;\n    separation 0.8;\n}\n"
        );
    }

    /// The figures of statistics.dat: value, low, high.
    std::map<std::string, std::vector<double>> figures(const std::string& name = "left") const
    {
        std::map<std::string, std::vector<double>> figures;
        std::istringstream in(samplesOf(case_.text("postProcessing/peakStatistics/" + name + "/statistics.dat")));
        for (std::string line; std::getline(in, line);)
        {
            std::istringstream words(line);
            std::string figure;
            words >> figure;
            for (double x; words >> x;)
            {
                figures[figure].push_back(x);
            }
        }
        return figures;
    }

    std::vector<std::vector<double>> peaks(const std::string& name = "left") const
    {
        return rowsOf(case_.text("postProcessing/peakStatistics/" + name + "/peaks.dat"));
    }

    /// Adds an entry to "left".
    void add(const std::string& entry) const
    {
        case_.edit("system/peakStatisticsDict", "separation 0.8;", "separation 0.8;\n    " + entry);
    }

    void expectRefused(const std::vector<std::string>& fragments, const std::string& options = "") const
    {
        const auto untouched = case_.tree();
        const Ended ended = case_.run("peakStatistics" + options);
        EXPECT_EQ(ended.status, 1);
        EXPECT_EQ(ended.err.find("\n--> FOAM FATAL"), 0u) << ended.err;
        for (const auto& fragment : fragments)
        {
            EXPECT_NE(ended.err.find(fragment), std::string::npos) << fragment << " is not in\n" << ended.err;
        }
        EXPECT_EQ(case_.tree(), untouched);
    }

    CaseDirectory case_;
};

TEST_F(PeakStatistics, WritesARowForEachPeakOfTheRunAndItsRestart)
{
    const std::string out = case_.succeed("peakStatistics");
    const auto rows = peaks();
    ASSERT_EQ(rows.size(), 7u);
    for (std::size_t k = 0; k < 7; ++k)
    {
        const double height = 600 + 100 * static_cast<double>(k);
        const std::vector<double> known{1 + static_cast<double>(k), height, 0.25, 0.25, 0.75 * height * 0.25};
        ASSERT_EQ(rows[k].size(), 10u);
        EXPECT_EQ(std::vector<double>(rows[k].begin(), rows[k].begin() + 5), known);
        for (std::size_t i = 0; i < 5; ++i)
        {
            // The sides fall by height/0.25 s: half of a window to each side of the top, half way to its ends.
            const double window = std::vector{0.001, 0.005, 0.01, 0.02, 0.04}[i];
            EXPECT_NEAR(rows[k][5 + i], height * (1 - window), 1e-4);
        }
    }
    for (const std::string file : {"peaks.dat", "statistics.dat"})
    {
        EXPECT_NE(out.find("Wrote postProcessing/peakStatistics/left/" + file), std::string::npos) << out;
    }
    // The table is what the file holds.
    EXPECT_NE(out.find(case_.text("postProcessing/peakStatistics/left/statistics.dat")), std::string::npos) << out;
}

TEST_F(PeakStatistics, SummarisesThePeaks)
{
    case_.succeed("peakStatistics");
    const auto all = figures();
    EXPECT_EQ(all.at("count"), std::vector<double>{7});
    EXPECT_EQ(all.at("mean"), std::vector<double>{900});
    EXPECT_NEAR(all.at("standardDeviation").at(0), 100 * std::sqrt(7 * 8 / 12.0), 1e-5);
    EXPECT_NEAR(all.at("standardError").at(0), 100 * std::sqrt(8 / 12.0), 1e-5);
    EXPECT_EQ(all.at("highestThird"), std::vector<double>{1150});
    EXPECT_EQ(all.at("highestTenth"), std::vector<double>{1200});
    EXPECT_EQ(all.at("maximum"), std::vector<double>{1200});
}

TEST_F(PeakStatistics, SummarisesTheMeansOverWindows)
{
    case_.succeed("peakStatistics");
    auto all = figures();
    EXPECT_NEAR(all.at("mean(0.04s)").at(0), 0.96 * 900, 1e-4);
    EXPECT_NEAR(all.at("standardDeviation(0.001s)").at(0), 0.999 * 100 * std::sqrt(7 * 8 / 12.0), 1e-4);
    add("windows (0.1 20);");
    case_.succeed("peakStatistics");
    all = figures();
    EXPECT_NEAR(all.at("mean(0.1s)").at(0), 0.9 * 900, 1e-4);
    EXPECT_EQ(all.count("mean(0.04s)"), 0u);
    EXPECT_EQ(all.count("mean(20s)"), 0u) << "longer than the record";
    EXPECT_NE(case_.text("postProcessing/peakStatistics/left/peaks.dat").find("mean 0.1 s"), std::string::npos);
    case_.edit("system/peakStatisticsDict", "windows (0.1 20);", "windows ();");
    case_.succeed("peakStatistics");
    EXPECT_EQ(peaks().front().size(), 5u);
}

TEST_F(PeakStatistics, FitsAWeibullDistributionAboveTheThresholdWithBounds)
{
    add("exceedance (0.1 0.01);");
    case_.succeed("peakStatistics");
    auto all = figures();
    EXPECT_EQ(all["location"], std::vector<double>{500});
    const double beta = all["shape"].at(0), eta = all["scale"].at(0);
    double sum = 0, sumLog = 0, meanLog = 0;
    for (double y = 100; y < 701; y += 100)
    {
        sum += std::pow(y, beta);
        sumLog += std::pow(y, beta) * std::log(y);
        meanLog += std::log(y) / 7;
    }
    EXPECT_NEAR(sumLog / sum - 1 / beta, meanLog, 1e-6);
    EXPECT_NEAR(eta, std::pow(sum / 7, 1 / beta), 1e-4);
    // 0.607927 = 6/pi^2; the bounds of a value as the header of WeibullFit states them.
    EXPECT_NEAR(std::log(all["shape"].at(2) / beta), 1.959964 * std::sqrt(0.607927 / 7), 1e-6);
    EXPECT_NEAR(std::log(eta / all["scale"].at(1)), 1.959964 * std::sqrt(1.108665 / 7) / beta, 1e-6);
    for (const auto& [name, probability] :
         {std::pair{"exceededBy(0.1)", 0.1}, {"exceededBy(0.01)", 0.01}, {"mostProbableMaximum", 1.0 / 7}})
    {
        const double w = std::log(-std::log(probability)), y = eta * std::exp(w / beta);
        const double spread =
            std::exp(1.959964 * std::sqrt((1.108665 - 2 * 0.257022 * w + 0.607927 * w * w) / 7) / beta);
        EXPECT_NEAR(all[name].at(0), 500 + y, 1e-3) << name;
        EXPECT_NEAR(all[name].at(1), 500 + y / spread, 1e-2) << name;
        EXPECT_NEAR(all[name].at(2), 500 + y * spread, 1e-2) << name;
    }
}

TEST_F(PeakStatistics, TakesConfidenceAndLocationOfTheFit)
{
    add("confidence 0.5; location 0; exceedance 0.5;");
    case_.succeed("peakStatistics");
    auto all = figures();
    EXPECT_EQ(all["location"], std::vector<double>{0});
    EXPECT_NEAR(std::log(all["shape"].at(2) / all["shape"].at(0)), 0.6744898 * std::sqrt(0.607927 / 7), 1e-6);
    EXPECT_NEAR(
        all["exceededBy(0.5)"].at(0), all["scale"].at(0) * std::pow(std::log(2.0), 1 / all["shape"].at(0)), 1e-4
    );
}

TEST_F(PeakStatistics, TakesColumnTimesSeparationAndFilter)
{
    case_.write("system/peakStatisticsDict", R"(
between { samples x/p; column 2; threshold 500; separation 0.8; timeStart 1.5; timeEnd 3.5; }
apart   { samples x/p; threshold 500; separation 1.5; }
smooth  { samples x/p; threshold 100; separation 0; filter 0.2; timeEnd 4.4; }
)");
    case_.succeed("peakStatistics");
    ASSERT_EQ(peaks("between").size(), 2u);
    EXPECT_EQ(peaks("between")[0][1], 1400);
    EXPECT_EQ(peaks("between")[1][1], 1600);
    std::vector<double> times;
    for (const auto& row : peaks("apart"))
    {
        times.push_back(row[0]);
    }
    EXPECT_EQ(times, (std::vector<double>{1, 3, 5, 7}));
    // The mean over 0.1 s to both sides of a top that falls over 0.25 s: 1 - 0.1/0.25/2 of it.
    ASSERT_EQ(peaks("smooth").size(), 4u);
    EXPECT_NEAR(peaks("smooth")[0][1], 0.8 * 600, 1e-5);
    EXPECT_NEAR(peaks("smooth")[3][1], 0.8 * 900, 1e-5);
}

TEST_F(PeakStatistics, SaysThatNoPeakIsAboveTheThreshold)
{
    case_.edit("system/peakStatisticsDict", "threshold 500", "threshold 1200");
    EXPECT_NE(case_.succeed("peakStatistics").find("no peak above 1200"), std::string::npos);
    EXPECT_EQ(figures(), (std::map<std::string, std::vector<double>>{{"count", {0}}}));
    EXPECT_TRUE(peaks().empty());
}

TEST_F(PeakStatistics, SaysThatPeaksAreTooFewOrTooEqualForAFit)
{
    add("timeEnd 4.5;");
    EXPECT_NE(case_.succeed("peakStatistics").find("a Weibull fit needs 5 values; there are 4"), std::string::npos);
    EXPECT_EQ(figures().at("maximum"), std::vector<double>{900});
    EXPECT_EQ(figures().count("shape"), 0u);
    case_.write("postProcessing/x/4.5/p", triangles(1, {700, 700, 700, 700, 700, 700}));
    case_.edit("system/peakStatisticsDict", "timeEnd 4.5;", "");
    EXPECT_NE(case_.succeed("peakStatistics").find("needs different values; all are 700"), std::string::npos);
    EXPECT_EQ(figures().at("standardDeviation"), std::vector<double>{0});
}

TEST_F(PeakStatistics, TakesAnotherDictionary)
{
    case_.write("system/roof", "roof { samples x/p; threshold 1000; separation 0; }");
    case_.remove("system/peakStatisticsDict");
    case_.succeed("peakStatistics -dict system/roof");
    EXPECT_EQ(peaks("roof").size(), 2u);
    expectRefused({"FOAM FATAL IO ERROR", "system/peakStatisticsDict"});
    expectRefused({"system/absent"}, " -dict system/absent");
}

TEST_F(PeakStatistics, RunsTheAnnotatedDictionary)
{
    fs::copy_file(
        fs::path(SLOSH_SOURCE) / "etc/annotated/system/peakStatisticsDict", case_.path() / "system/peakStatisticsDict",
        fs::copy_options::overwrite_existing
    );
    case_.write("postProcessing/pressure/0/p", triangles(9, {9000, 9000, 600, 700, 800, 900, 1000, 499}));
    case_.succeed("peakStatistics");
    // From 10 s on, the peak of 9000 at that instant among them; 499 is too low, twice as much is not.
    EXPECT_EQ(peaks("left").size(), 6u);
    EXPECT_EQ(peaks("right").size(), 7u);
    EXPECT_EQ(figures("right").at("exceededBy(0.01)").size(), 3u);
}

TEST_F(PeakStatistics, RefusesAnUnknownKeyWithTheNearest)
{
    add("treshold 600;");
    expectRefused({"system/peakStatisticsDict:6: unknown keyword 'treshold'; did you mean 'threshold'?", "exceedance"});
}

TEST_F(PeakStatistics, NamesAMissingKey)
{
    case_.edit("system/peakStatisticsDict", "    threshold 500;\n", "");
    expectRefused({"entry 'threshold' not found in dictionary \"system/peakStatisticsDict/left\""});
}

TEST_F(PeakStatistics, NamesMissingSamplesAndWhoAskedForThem)
{
    case_.edit("system/peakStatisticsDict", "x/p", "y/p");
    expectRefused({"postProcessing/y/<startTime>/p", "has the case been run?", "system/peakStatisticsDict:1: left: "});
}

TEST_F(PeakStatistics, NamesAColumnThatIsNotThere)
{
    add("column 3;");
    expectRefused(
        {"column 3 (from 0) not found; there are 3", "postProcessing/x/0/p:4: ", "system/peakStatisticsDict:1: left: "}
    );
    case_.edit("system/peakStatisticsDict", "column 3", "column 0");
    expectRefused({"system/peakStatisticsDict:6: column is 0; expected a whole number >= 1"});
}

TEST_F(PeakStatistics, RefusesValuesOutOfTheirRange)
{
    for (const auto& [entry, message] : std::vector<std::pair<std::string, std::string>>{
             {"separation -0.8;", "separation is -0.8"},
             {"threshold -1;", "threshold is -1"},
             {"filter -0.002;", "filter is -0.002"},
             {"windows (0.01 0);", "windows is (0.01 0)"},
             {"location 501;", "location is 501"},
             {"exceedance 0;", "exceedance is 0"},
             {"exceedance (0.1 1);", "exceedance is (0.1 1)"},
             {"exceedance ();", "exceedance is empty; expected probabilities"},
             {"confidence 1;", "confidence is 1"},
             {"timeStart 5; timeEnd 5;", "timeEnd is not after timeStart"}})
    {
        case_.write(
            "system/peakStatisticsDict",
            "left\n{\n    samples x/p;\n    threshold 500;\n    separation 0.8;\n    " + entry + "\n}\n"
        );
        expectRefused({message, "system/peakStatisticsDict:6: "});
    }
}

TEST_F(PeakStatistics, RefusesTimesWithoutSamples)
{
    add("timeStart 20; timeEnd 30;");
    expectRefused({"no samples from 20 to 30 s; samples range from 0.75 to 8.25 s", "left: no samples"});
}

TEST_F(PeakStatistics, WritesNothingWhereOneOfManyEntriesIsWrong)
{
    case_.write(
        "system/peakStatisticsDict", "good { samples x/p; threshold 500; separation 0; }\n"
                                     "bad { samples y/p; threshold 500; separation 0; }\n"
    );
    expectRefused({"system/peakStatisticsDict:2: bad: "});
}

TEST_F(PeakStatistics, RefusesADictionaryWithoutEntriesOrWithValues)
{
    case_.write("system/peakStatisticsDict", "");
    expectRefused({"system/peakStatisticsDict: no entry found; expected <name>"});
    case_.write("system/peakStatisticsDict", "threshold 500;");
    expectRefused({"system/peakStatisticsDict:1: threshold is a value; expected a dictionary { ... }"});
    case_.write("system/peakStatisticsDict", "../../left { samples x/p; threshold 500; separation 0; }");
    expectRefused({"system/peakStatisticsDict:1: ../../left is not valid as the name of a folder"});
}

TEST_F(PeakStatistics, HasOpenFOAMsHabitsOnTheCommandLine)
{
    EXPECT_NE(case_.succeed("peakStatistics -help").find("Usage: peakStatistics"), std::string::npos);
    expectRefused({"Invalid option: -dcit; did you mean -dict?", "See 'peakStatistics -help' for usage"}, " -dcit x");
    expectRefused({"cannot open case directory \"absent\""}, " -case absent");
}

} // namespace
} // namespace slosh
