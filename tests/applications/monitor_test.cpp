// SPDX-License-Identifier: GPL-3.0-or-later
// sloshMonitor, as users start it on a running or finished case: the script it gives gnuplot, and the picture.
#include "CaseDirectory.hpp"
#include "samples.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <sstream>

namespace slosh
{
namespace
{

namespace fs = std::filesystem;

const std::string pressureHeader = "# Probe 0 (0 -0.1 0.05)\n# Probe 1 (0 0.1 0.05)\n"
                                   "#       Probe             0             1\n#        Time\n";

/// A case of which only samples are there.
class Monitor : public testing::Test
{
protected:
    Monitor()
    {
        samples(
            "pressure/0/p", pressureHeader + "            0           500           501\n"
                                             "          0.1           510           511\n"
                                             "          0.2           520           521\n"
        );
    }

    void samples(const std::string& file, const std::string& text) const
    {
        case_.write("postProcessing/" + file, text);
    }

    std::string script(const std::string& options = "") const
    {
        return case_.succeed("sloshMonitor -script " + options);
    }

    void expectRefused(const std::string& options, const std::string& words) const
    {
        const auto before = case_.tree();
        const Ended ended = case_.run("sloshMonitor " + options);
        EXPECT_EQ(ended.status, 1) << options;
        EXPECT_NE(ended.err.find("--> FOAM FATAL ERROR:\n"), std::string::npos) << ended.err;
        EXPECT_NE(ended.err.find(words), std::string::npos) << ended.err;
        EXPECT_EQ(case_.tree(), before) << "left behind by " << options;
    }

    const CaseDirectory case_;
};

/// The points of curve number k (from 1) of a script.
std::string curve(const std::string& script, int k)
{
    const std::string begin = "$d" + std::to_string(k) + " << EOD\n";
    const auto at = script.find(begin);
    return at == std::string::npos
               ? ""
               : script.substr(at + begin.size(), script.find("EOD\n", at + begin.size()) - at - begin.size());
}

/// Width and height that the head of a PNG file states.
std::pair<int, int> sizeOfPng(const std::string& file)
{
    EXPECT_EQ(file.substr(0, 8), "\x89PNG\r\n\x1a\n");
    const auto number = [&](std::size_t at)
    {
        int n = 0;
        for (std::size_t k = 0; k < 4; ++k)
        {
            n = 256 * n + static_cast<unsigned char>(file.at(at + k));
        }
        return n;
    };
    EXPECT_EQ(file.substr(file.size() - 8, 4), "IEND") << "not whole";
    return {number(16), number(20)};
}

TEST_F(Monitor, GivesGnuplotTheSamplesOfEachColumn)
{
    const std::string text = script();
    EXPECT_EQ(curve(text, 1), "0 500\n0.1 510\n0.2 520\n");
    EXPECT_EQ(curve(text, 2), "0 501\n0.1 511\n0.2 521\n");
    EXPECT_EQ(curve(text, 3), "");
    for (const std::string words :
         {"\"pressure [Pa]\"", "p0 (0 -0.1 0.05)", "p1 (0 0.1 0.05)", "\"time [s]\"", "t = 0.2 s"})
    {
        EXPECT_NE(text.find(words), std::string::npos) << words;
    }
}

TEST_F(Monitor, JoinsTheFoldersOfARestartInTheOrderOfTime)
{
    // It was sampled until 0.2, written at 0.1, and has gone on from there; 10 comes after 9.
    samples("pressure/0.1/p", pressureHeader + "         0.15            15             0\n");
    samples("pressure/10/p", pressureHeader + "         10.5           105             0\n");
    samples("pressure/9/p", pressureHeader + "          9.5            95             0\n");
    EXPECT_EQ(curve(script(), 1), "0 500\n0.1 510\n0.15 15\n9.5 95\n10.5 105\n");
    EXPECT_EQ(curve(script("-from 9"), 1), "9.5 95\n10.5 105\n");
    EXPECT_NE(case_.succeed("sloshMonitor -list").find("pressure/p: t = 0 to 10.5 s, 5 samples"), std::string::npos);
}

TEST_F(Monitor, KeepsAProbeItsCurveWhereARestartHasAnotherOrderOfProbes)
{
    samples(
        "pressure/0.2/p", "# Probe 0 (0 0.1 0.05)\n# Probe 1 (0 0 0.05)\n#       Probe             0             1\n"
                          "#        Time\n          0.3           531           532\n"
    );
    const std::string text = script();
    // The second of before is the first now.
    EXPECT_EQ(curve(text, 1), "0 500\n0.1 510\n0.2 520\n");
    EXPECT_EQ(curve(text, 2), "0 501\n0.1 511\n0.2 521\n0.3 531\n");
    EXPECT_EQ(curve(text, 3), "0.3 532\n");
    for (const std::string name : {"p0_before (0 -0.1 0.05)", "p0 (0 0.1 0.05)", "p1 (0 0 0.05)"})
    {
        EXPECT_NE(text.find(name), std::string::npos) << name;
    }
}

TEST_F(Monitor, LeavesOutALineThatIsBeingWritten)
{
    const std::string whole = case_.text("postProcessing/pressure/0/p");
    for (const std::string part :
         {"          0.3", "          0.3           530", "          0.3           530           53"})
    {
        samples("pressure/0/p", whole + part);
        EXPECT_EQ(curve(script(), 2), "0 501\n0.1 511\n0.2 521\n") << part;
    }
    samples("pressure/0/p", whole + "          0.3           530           53\n");
    EXPECT_EQ(curve(script(), 2), "0 501\n0.1 511\n0.2 521\n0.3 53\n");
}

TEST_F(Monitor, KeepsThePeaksOfManySamples)
{
    std::ostringstream rows;
    for (int i = 0; i < 20000; ++i)
    {
        rows << i * 1e-3 << " " << (i == 12345 ? 9000 : i % 7) << " 0\n";
    }
    samples("pressure/0/p", pressureHeader + rows.str());
    const auto points = rowsOf(curve(script(), 1));
    EXPECT_LE(points.size(), 3002u);
    EXPECT_GE(points.size(), 1500u);
    EXPECT_TRUE(std::any_of(
        points.begin(), points.end(), [](const auto& point) { return point[0] == 12.345 && point[1] == 9000; }
    ));
    EXPECT_TRUE(std::is_sorted(points.begin(), points.end()));
}

TEST_F(Monitor, DrawsTheFunctionsAndColumnsAskedFor)
{
    samples(
        "forces/0/force.dat", "# Force\n# Time\t(total_x total_y total_z)\t(pressure_x pressure_y pressure_z)\n"
                              "0\t(0 1 2)\t(0 1 2)\n1\t(0 3 4)\t(0 3 4)\n"
    );
    samples(
        "gauges/0/height.dat", "# Location : (0 0.1 0)\n# Location\t0\t \n# Time\thB\thL\n0\t0.5\t0.4\n1\t0.6\t0.5\n"
    );
    const std::string forces = script("-function forces/force");
    // The empty direction of a 2D tank is left out.
    EXPECT_EQ(curve(forces, 1), "0 1\n1 3\n");
    EXPECT_EQ(curve(forces, 2), "0 2\n1 4\n");
    EXPECT_EQ(curve(forces, 3), "");
    EXPECT_NE(forces.find("\"force [N]\""), std::string::npos);
    EXPECT_EQ(curve(script("-function forces -columns pressure_z"), 1), "0 2\n1 4\n");
    const std::string two = script("-function gauges,pressure -columns hL0,p1");
    EXPECT_EQ(curve(two, 1), "0 0.4\n1 0.5\n");
    EXPECT_EQ(curve(two, 2), "0 501\n0.1 511\n0.2 521\n");
}

TEST_F(Monitor, RefusesWhatItDoesNotKnowAndNamesWhatIsValid)
{
    expectRefused("-list -function presure", "did you mean pressure?\nValid functions: pressure");
    expectRefused(
        "-script -columns p7", "Unknown column 'p7' in ./postProcessing; did you mean p0?\nValid columns: p0 p1"
    );
    expectRefused("-script -from 5", "no sample from t = 5 s on");
    expectRefused(
        "-functions pressure", "Invalid option: -functions; did you mean -function?\nSee 'sloshMonitor -help'"
    );
    expectRefused("pressure", "takes options only");
    expectRefused("-every never", "'-every' is never; expected a number from 0.1 to 86400 [s]");
    expectRefused("-from soon", "'-from' is soon");
    expectRefused("-size big", "'-size' is big");
    expectRefused("-png", "the argument of '-png' is missing");
    expectRefused("-once -png absent/a.png", "cannot write absent/a.png");
    expectRefused("-case absent", "cannot open case directory \"absent\"");
}

TEST_F(Monitor, SaysThatNothingHasBeenSampledYet)
{
    samples("pressure/0/p", pressureHeader);
    expectRefused("-once -png a.png", "no sample yet in ./postProcessing");
    EXPECT_NE(case_.succeed("sloshMonitor -list").find("pressure/p: no sample yet"), std::string::npos);
    case_.remove("postProcessing/pressure");
    expectRefused("-once -png a.png", "there are no samples in ./postProcessing");
    case_.remove("postProcessing");
    expectRefused("-once -png a.png", "there is no folder ./postProcessing: sloshSPHFoam creates it");
}

TEST_F(Monitor, DrawsAPictureInWhichTheCurvesCanBeSeen)
{
    case_.succeed("sloshMonitor -once -png first.png -size 800x400");
    EXPECT_EQ(sizeOfPng(case_.text("first.png")), std::make_pair(800, 400));
    case_.succeed("sloshMonitor -once -png again.png -size 800x400");
    EXPECT_TRUE(case_.text("first.png") == case_.text("again.png"));
    samples("pressure/0/p", pressureHeader + "0 500 501\n0.1 514 511\n0.2 520 521\n"); // the same axes
    case_.succeed("sloshMonitor -once -png other.png -size 800x400");
    EXPECT_FALSE(case_.text("first.png") == case_.text("other.png")) << "a sample cannot be seen";
}

TEST_F(Monitor, DrawsAWholeRunAndNamesWhatItLeavesOut)
{
    case_.succeed("blockParticles");
    case_.succeed("sloshSPHFoam -threads 1");
    const std::string said = case_.succeed("sloshMonitor -once -png run.png");
    EXPECT_NE(said.find("Picture: run.png"), std::string::npos);
    EXPECT_EQ(sizeOfPng(case_.text("run.png")).first, 1600);
    const std::string text = script();
    for (const std::string words :
         {"\"pressure [Pa]\"", "\"surface above bottom [m]\"", "\"force [N]\"", "\"energy [J]\"", "\"moment [N m]\""})
    {
        EXPECT_NE(text.find(words), std::string::npos) << words;
    }
    EXPECT_EQ(rowsOf(curve(text, 1)).size(), 11u);
}

TEST_F(Monitor, DrawsAgainWhatIsNewUntilItIsEnded)
{
    case_.write(
        "watch", "#!/bin/bash\n" SLOSH_BIN "/sloshMonitor -png live.png -every 0.1 > said &\npid=$!\n"
                 "while ! [ -f live.png ] && kill -0 $pid; do :; done\ncp live.png before.png\n"
                 "echo '          0.3           900           100' >> postProcessing/pressure/0/p\n"
                 "while cmp -s live.png before.png && kill -0 $pid; do :; done\n"
                 "kill -TERM $pid\nwait $pid\n[ $? = 143 ] && [ -z \"$(ls .monitor* 2> /dev/null)\" ]\n"
    );
    fs::permissions(case_.path() / "watch", fs::perms::owner_exec, fs::perm_options::add);
    const Ended ended = case_.run("./watch");
    EXPECT_EQ(ended.status, 0) << ended.err;
    EXPECT_EQ(sizeOfPng(case_.text("live.png")).first, 1600);
}

TEST_F(Monitor, DrawsIntoTheCaseWhereThereIsNoDisplay)
{
    const Ended ended = case_.run("sloshMonitor -once", "unset DISPLAY WAYLAND_DISPLAY;");
    EXPECT_EQ(ended.status, 0) << ended.err;
    EXPECT_NE(ended.out.find("No display"), std::string::npos);
    EXPECT_EQ(sizeOfPng(case_.text("postProcessing/monitor.png")).first, 1600);
}

} // namespace
} // namespace slosh
