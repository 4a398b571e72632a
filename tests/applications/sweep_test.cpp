// SPDX-License-Identifier: GPL-3.0-or-later
// sloshSweep as a user starts it: which cases, what is set in them, resuming, failures, stopping, bad input.
#include "SloshSweepTest.hpp"
#include "installed.hpp"

#include "dictionary/Dictionary.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <sstream>

namespace slosh
{
namespace
{

namespace fs = std::filesystem;

/// Of the tank of 0.2 m, by Lamb, Hydrodynamics, art. 257.
double naturalFrequency(int n, double depth)
{
    const double k = n * std::numbers::pi / 0.2;
    return std::sqrt(9.81 * k * std::tanh(k * depth));
}

TEST_F(SloshSweep, ListsTheProductOfItsAxesWithTheNaturalFrequenciesOfEachDepth)
{
    case_.writeSweep(frequency + angle + depth, peak);
    const auto before = case_.tree();
    const std::string out = case_.succeed("sloshSweep -dry-run");
    std::istringstream lines(out.substr(out.find("case  frequency")));
    std::string line;
    std::getline(lines, line);
    int number = 0;
    for (const double multiple : {0.8, 1.0, 1.2})
    {
        for (const double degrees : {2.0, 4.0})
        {
            for (const double h : {0.06, 0.1})
            {
                std::getline(lines, line);
                std::istringstream cells(line);
                int k = 0;
                double given = 0, amplitude = 0, fill = 0, omega = 0, omega1 = 0, omega2 = 0, omega3 = 0;
                std::string status;
                cells >> k >> given >> amplitude >> fill >> omega >> omega1 >> omega2 >> omega3 >> status;
                EXPECT_EQ(k, ++number);
                EXPECT_EQ(given, multiple);
                EXPECT_EQ(amplitude, degrees);
                EXPECT_EQ(fill, h);
                EXPECT_NEAR(omega, multiple * naturalFrequency(1, h), 1e-4);
                EXPECT_NEAR(omega1, naturalFrequency(1, h), 1e-4);
                EXPECT_NEAR(omega2, naturalFrequency(2, h), 1e-4);
                EXPECT_NEAR(omega3, naturalFrequency(3, h), 1e-4);
                EXPECT_EQ(status, "waiting");
            }
        }
    }
    EXPECT_EQ(number, 12);
    EXPECT_EQ(case_.tree(), before);
}

TEST_F(SloshSweep, SetsTheValuesInACopyOfTheCaseEach)
{
    case_.writeSweep(frequency + angle + depth, "");
    const std::string base = case_.text("constant/dynamicMeshDict");
    case_.succeed("sloshSweep -only 8"); // 1 4deg 0.1 m
    EXPECT_EQ(case_.runs(), std::set<std::string>{"frequency=1_angle=4_depth=0.1"});
    const fs::path run = case_.path() / sweepFolder / "runs/frequency=1_angle=4_depth=0.1";
    const Dictionary motion = Dictionary::read(run / "constant/dynamicMeshDict", "motion");
    const Dictionary coeffs = motion.dict("oscillatingRotatingMotionCoeffs");
    EXPECT_NEAR(coeffs.scalar("omega", unit::radianPerSecond) / naturalFrequency(1, 0.1), 1, 1e-13);
    EXPECT_EQ(coeffs.vector("amplitude", unit::degree), Vec(4, 0, 0));
    EXPECT_EQ(coeffs.vector("origin", unit::metre), Vec(0, 0, 0.1)) << "what is not varied stays";
    EXPECT_EQ(Dictionary::read(run / "constant/tankProperties", "tank").scalar("fillDepth", unit::metre), 0.1);
    EXPECT_EQ(case_.text("constant/dynamicMeshDict"), base);
    EXPECT_NE(
        case_.text(sweepFolder + "runs/frequency=1_angle=4_depth=0.1/log.sloshSPHFoam").find("amplitude (4 0 0)"),
        std::string::npos
    );
    EXPECT_FALSE(fs::exists(case_.path() / (sweepFolder + "sweep.tsv"))) << "the table belongs to all cases";
}

TEST_F(SloshSweep, TabulatesTheSameInTheSameOrderForAnyNumberOfJobs)
{
    const SweepCase other;
    for (const SweepCase* one : {&case_, &other})
    {
        one->writeSweep(
            angle + depth, peak + "level { $peak; samples \"gauges/height.dat\"; unit m; quantity meanPeak; "
                                  "period 0.004; reference { type stated; value 0.1; } }"
        );
    }
    case_.succeed("sloshSweep -jobs 1");
    other.succeed("sloshSweep -jobs 3");
    const auto rows = case_.table(), same = other.table();
    ASSERT_EQ(rows.size(), 4u);
    ASSERT_EQ(same.size(), 4u);
    for (std::size_t k = 0; k < rows.size(); ++k)
    {
        auto row = rows[k], its = same[k];
        row.erase("CPU [s]");
        its.erase("CPU [s]");
        EXPECT_EQ(row, its);
        EXPECT_EQ(row["# case"], std::to_string(k + 1));
        EXPECT_EQ(row["angle [deg]"], k < 2 ? "2" : "4");
        EXPECT_EQ(row["depth [m]"], k % 2 == 0 ? "0.06" : "0.1");
        EXPECT_EQ(row["omega [rad/s]"], "8");
        EXPECT_EQ(row["status"], "finished");
        EXPECT_EQ(row["level reference"], "0.1");
        EXPECT_GE(std::stod(row["level +-"]), 0);
        // The largest pressure at the deep probe is the file's.
        std::istringstream samples(case_.text(
            sweepFolder + "runs/angle=" + row["angle [deg]"] + "_depth=" + row["depth [m]"] +
            "/postProcessing/pressure/0/p"
        ));
        double highest = 0;
        for (std::string line; std::getline(samples, line);)
        {
            std::istringstream in(line);
            double t = 0, p = 0;
            highest = line[0] != '#' && in >> t >> p ? std::max(highest, p) : highest;
        }
        EXPECT_GT(highest, 0);
        EXPECT_NEAR(std::stod(row["peak [Pa]"]), highest, 1e-5 * highest);
    }
    if (isInstalled("gnuplot"))
    {
        EXPECT_GT(fs::file_size(case_.path() / (sweepFolder + "sweep.png")), 1000u);
        EXPECT_GT(fs::file_size(case_.path() / (sweepFolder + "sweep.svg")), 1000u);
    }
}

TEST_F(SloshSweep, TakesAnEntryThatHasMoreOfAnotherThanItNeedsAsCompareSamplesDoes)
{
    case_.writeSweep(
        angle, peak + "rise { $peak; quantity firstTimeAbove; level 10; unit s; } "
                      "mean { $rise; quantity largestMean; window 0.002; unit Pa; } "
                      "alone { samples \"pressure/p\"; column 1; quantity largestMean; window 0.002; }"
    );
    case_.succeed("sloshSweep -jobs 1");
    const auto rows = case_.table();
    ASSERT_EQ(rows.size(), 2u);
    for (auto row : rows)
    {
        EXPECT_EQ(row["mean [Pa]"], row["alone"]);
        EXPECT_GT(std::stod(row["mean [Pa]"]), 0);
    }
}

TEST_F(SloshSweep, RunsNothingTwiceAndMakesAnewWhatHasChanged)
{
    case_.writeSweep(angle, peak);
    case_.succeed("sloshSweep");
    const auto times = case_.timesOfRuns();
    const std::string again = case_.succeed("sloshSweep");
    EXPECT_EQ(case_.timesOfRuns(), times);
    EXPECT_NE(again.find("[2/2] angle=4: finished"), std::string::npos) << again;

    // A value more is a case more.
    case_.edit("system/sweepDict", "(2 4)", "(2 4 6)");
    case_.succeed("sloshSweep");
    EXPECT_EQ(case_.runs(), (std::set<std::string>{"angle=2", "angle=4", "angle=6"}));
    for (const auto& [file, time] : times)
    {
        EXPECT_EQ(case_.timesOfRuns()[file], time) << file;
    }

    // A result more is no run more, another case is.
    case_.edit("system/sweepDict", "quantity maximum", "quantity minimum");
    const Ended unmade = case_.run("sloshSweep -collect");
    EXPECT_NE(unmade.err.find("angle=2: finished: no results: the comparisons are missing"), std::string::npos)
        << unmade.err;
    const std::string compared = case_.succeed("sloshSweep");
    EXPECT_EQ(compared.find("repeated"), std::string::npos) << compared;
    case_.edit("constant/dynamicMeshDict", "omega 8", "omega 9");
    const std::string anew = case_.succeed("sloshSweep");
    EXPECT_NE(anew.find("repeated, changed: constant/dynamicMeshDict"), std::string::npos) << anew;
    EXPECT_EQ(case_.table()[2]["omega [rad/s]"], "9");
}

TEST_F(SloshSweep, SaysWhichCaseHasFailedAndWhyAndRunsTheOthers)
{
    case_.writeSweep("limit { file \"system/sphSchemes\"; entry limits.densityDeviation; values (1e-9 0.3); }", peak);
    const Ended ended = case_.run("sloshSweep");
    EXPECT_EQ(ended.status, 1);
    EXPECT_NE(ended.err.find("1 of 2 cases has no result"), std::string::npos) << ended.err;
    auto rows = case_.table();
    ASSERT_EQ(rows.size(), 2u);
    EXPECT_EQ(rows[0]["status"], "failed");
    EXPECT_NE(rows[0]["reason"].find("density"), std::string::npos) << rows[0]["reason"];
    EXPECT_EQ(rows[0]["peak [Pa]"], "nan");
    EXPECT_EQ(rows[1]["status"], "finished");
    EXPECT_EQ(rows[1]["reason"], "-");

    const auto times = case_.timesOfRuns();
    EXPECT_EQ(case_.run("sloshSweep").status, 1);
    EXPECT_EQ(case_.timesOfRuns(), times) << "what has failed would fail again";
    EXPECT_EQ(case_.run("sloshSweep -retry").status, 1);
    EXPECT_NE(case_.timesOfRuns(), times);
}

TEST_F(SloshSweep, SaysWhyAFinishedCaseHasNoResults)
{
    case_.writeSweep(angle, "peak { samples \"presure/p\"; column 1; quantity maximum; }");
    EXPECT_EQ(case_.run("sloshSweep").status, 1);
    EXPECT_EQ(case_.table()[0]["status"], "finished");
    EXPECT_NE(case_.table()[0]["reason"].find("no samples"), std::string::npos) << case_.table()[0]["reason"];
    case_.edit("system/sweepDict", "presure", "pressure");
    const std::string out = case_.succeed("sloshSweep");
    EXPECT_NE(out.find("(finished earlier)"), std::string::npos) << out;
}

TEST_F(SloshSweep, RemovesWhatASettingRemoves)
{
    case_.writeSweep(
        "viscosity { settings { own { } ofTheScheme { constant { fluidProperties { #remove viscosity } } } } }", peak
    );
    case_.edit("constant/fluidProperties", "alpha 0.03", "alpha 0.05");
    case_.succeed("sloshSweep");
    const std::string runs = sweepFolder + "runs/viscosity=";
    EXPECT_NE(
        case_.text(runs + "own/log.sloshSPHFoam").find("viscosity/alpha 0.05 (constant/fluidProperties:"),
        std::string::npos
    );
    EXPECT_NE(
        case_.text(runs + "ofTheScheme/log.sloshSPHFoam").find("viscosity/alpha 0.03 (scheme cao2014)"),
        std::string::npos
    );
}

TEST_F(SloshSweep, StoppedBySigtermStopsItsSolversAndGoesOnToTheSameResults)
{
    const std::string lengths = "length { settings { long { \"system/controlDict\" { endTime 2; } } short { } } }";
    const SweepCase other;
    case_.writeSweep(lengths, peak);
    other.writeSweep(lengths, peak);
    const std::string log = sweepFolder + "runs/length=long/log.sloshSPHFoam";
    case_.write(
        "stop", SLOSH_BIN "/sloshSweep -jobs 1 > out 2>&1 &\npid=$!\n"
                          "tail --pid=$pid -s 0.05 -n +1 -F " +
                    log +
                    " 2> /dev/null | grep -q -m 1 '^ExecutionTime'\n"
                    "kill -TERM $pid; wait $pid; echo $? > status\n"
    );
    EXPECT_EQ(case_.run("./stop", "bash").status, 0);
    EXPECT_EQ(case_.text("status"), "143\n") << case_.text("out");
    EXPECT_NE(case_.text(log).find("Stopped by SIGTERM"), std::string::npos);
    auto rows = case_.table();
    ASSERT_EQ(rows.size(), 2u);
    EXPECT_EQ(rows[0]["status"], "stopped");
    EXPECT_EQ(rows[1]["status"], "waiting");

    const std::string out = case_.succeed("sloshSweep -jobs 1");
    EXPECT_NE(out.find("(continued from "), std::string::npos) << out;
    other.succeed("sloshSweep -jobs 2");
    for (std::size_t k = 0; k < 2; ++k)
    {
        EXPECT_EQ(case_.table()[k]["status"], "finished");
        EXPECT_EQ(case_.table()[k]["peak [Pa]"], other.table()[k]["peak [Pa]"]);
    }
}

TEST_F(SloshSweep, CollectsWhatItsCasesHaveLeftOneByOne)
{
    case_.writeSweep(angle, peak);
    case_.succeed("sloshSweep -only 2");
    const Ended half = case_.run("sloshSweep -collect");
    EXPECT_EQ(half.status, 1);
    EXPECT_NE(half.err.find("angle=2: waiting"), std::string::npos) << half.err;
    EXPECT_EQ(case_.table()[1]["status"], "finished");
    case_.succeed("sloshSweep -only 1");
    const auto times = case_.timesOfRuns();
    case_.succeed("sloshSweep -collect");
    EXPECT_EQ(case_.timesOfRuns(), times);
    EXPECT_EQ(case_.table()[0]["status"], "finished");
}

TEST_F(SloshSweep, FindsTheResonanceOfLinearTheory)
{
    const CaseDirectory sway;
    for (const std::string folder : {"constant", "system"})
    {
        sway.remove(folder);
        fs::copy(
            SLOSH_SOURCE "/tutorials/swayingTank/response/" + folder, sway.path() / folder, fs::copy_options::recursive
        );
    }
    sway.edit("system/blockParticlesDict", "particleSpacing 0.025", "particleSpacing 0.05");
    sway.edit("system/sweepDict", "count           7", "count           3");
    const Ended ended = sway.run("sloshSweep", "env SLOSH_ETC='" SLOSH_SOURCE "/etc'");
    ASSERT_EQ(ended.status, 0) << ended.err;
    const auto rows = tableOf(sway);
    ASSERT_EQ(rows.size(), 3u);
    for (auto row : rows)
    {
        const double range = std::stod(row["range [m]"]), linear = std::stod(row["range reference"]);
        EXPECT_NEAR(range / linear, 1, 0.2) << row["frequency [omega/omega1]"];
    }
    const auto range = [&](std::size_t k) { return std::stod(std::map(rows[k])["range [m]"]); };
    EXPECT_GT(range(1), 3 * range(0));
    EXPECT_GT(range(1), 3 * range(2));
}

TEST_F(SloshSweep, IsAJobArrayOfSlurm)
{
    case_.writeSweep(angle, peak, "slurm { threads 1; options (\"--time=10\"); }");
    case_.succeed("sloshSweep -slurm -jobs 2");
    const std::string script = case_.text("sweep.sbatch");
    EXPECT_NE(script.find("\n#SBATCH --array=1-2%2\n"), std::string::npos) << script;
    EXPECT_NE(script.find("\n#SBATCH --time=10\n"), std::string::npos) << script;
    const std::string cluster = case_.path().string() + ".slurm";
    const Ended ended = case_.run(
        SLOSH_SOURCE "/tests/applications/withSlurm '" + cluster +
        "' bash -c 'sbatch --wait sweep.sbatch && " SLOSH_BIN "/sloshSweep -collect'"
    );
    fs::remove_all(cluster);
    if (ended.status == 77)
    {
        GTEST_SKIP() << ended.err;
    }
    ASSERT_EQ(ended.status, 0) << ended.out << ended.err;
    EXPECT_NE(ended.out.find("Submitted batch job"), std::string::npos) << ended.out;
    const auto rows = case_.table();
    ASSERT_EQ(rows.size(), 2u);
    for (std::size_t k = 0; k < 2; ++k)
    {
        EXPECT_EQ(std::map(rows[k])["status"], "finished");
        EXPECT_NE(
            case_.text("log.sloshSweep." + std::to_string(k + 1)).find("] angle=" + std::to_string(2 * k + 2)),
            std::string::npos
        );
    }
}

} // namespace
} // namespace slosh
