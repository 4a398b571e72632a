// SPDX-License-Identifier: GPL-3.0-or-later
// A run that is asked for something while it runs: by controlDict or by a signal.
#include "CaseDirectory.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <set>

namespace slosh
{
namespace
{

namespace fs = std::filesystem;

/// A case that would run for some seconds and write nothing.
class Steering : public testing::Test
{
protected:
    Steering()
    {
        case_.edit("system/controlDict", "endTime 0.1;", "endTime 20; runTimeModifiable yes;");
        case_.edit("system/controlDict", "writeInterval 0.05;", "writeInterval 100;");
        case_.succeed("blockParticles");
    }

    /// Starts the solver, waits for its first block of lines, then for `commands` of a shell (the solver is $pid) and
    /// for its end. Its exit status; what it says is in log.
    Ended steer(const std::string& commands) const
    {
        case_.write(
            "steer", "#!/bin/bash\nmkfifo pipe\n" SLOSH_BIN "/sloshSPHFoam -threads 1 > pipe 2> err &\npid=$!\n"
                     "{ grep --line-buffered -m 1 '^ExecutionTime'; " +
                         commands + "; cat; } < pipe > log\nwait $pid; status=$?; rm pipe; cat err >&2; exit $status\n"
        );
        fs::permissions(case_.path() / "steer", fs::perms::owner_exec, fs::perm_options::add);
        return case_.run("./steer");
    }

    std::set<double> times() const
    {
        std::set<double> times;
        for (const auto& item : fs::directory_iterator(case_.path()))
        {
            if (fs::is_directory(item.path() / "lagrangian"))
            {
                times.insert(std::stod(item.path().filename()));
            }
        }
        return times;
    }

    /// The one time written besides the start.
    double stopped() const
    {
        const auto written = times();
        EXPECT_EQ(written.size(), 2u);
        return *written.rbegin();
    }

    const CaseDirectory case_;
};

TEST_F(Steering, WritesAndStopsWhereControlDictSaysSoWhileItRuns)
{
    const Ended ended = steer("sed -i 's/endTime 20;/endTime 20; stopAt writeNow;/' system/controlDict");
    EXPECT_EQ(ended.status, 0) << ended.err;
    EXPECT_GT(stopped(), 0);
    EXPECT_LT(stopped(), 20);
    const std::string log = case_.text("log");
    EXPECT_NE(log.find("system/controlDict has changed"), std::string::npos);
    EXPECT_NE(log.find("Stopped by stopAt writeNow at t = "), std::string::npos);
    EXPECT_EQ(log.substr(log.size() - 4), "End\n");
}

TEST_F(Steering, GoesOnWhereControlDictBecomesWrongWhileItRuns)
{
    const Ended ended = steer("sed -i 's/endTime 20;/endTime many;/' system/controlDict; "
                              "grep --line-buffered -m 1 'endTime.*many'; "
                              "sed -i 's/endTime many;/endTime 20; stopAt noWriteNow;/' system/controlDict");
    EXPECT_EQ(ended.status, 0) << ended.err;
    EXPECT_EQ(times().size(), 1u);
    EXPECT_NE(case_.text("log").find("Stopped by stopAt noWriteNow"), std::string::npos);
}

TEST_F(Steering, KeepsItsStepWhereControlDictAsksForOneThatIsNotStable)
{
    const Ended ended = steer("sed -i 's/endTime 20;/endTime 20; maxCo 5;/' system/controlDict; "
                              "grep --line-buffered -m 1 \"maxCo is 5; expected at most 0.944\"; "
                              "sed -i 's/maxCo 5;/stopAt noWriteNow;/' system/controlDict");
    EXPECT_EQ(ended.status, 0) << ended.err;
    EXPECT_NE(case_.text("log").find("maxCo is 5; expected at most 0.944"), std::string::npos);
    EXPECT_NE(case_.text("log").find("Stopped by stopAt noWriteNow"), std::string::npos);
}

TEST_F(Steering, WritesAndStopsAtSigterm)
{
    const Ended ended = steer("kill -TERM $pid");
    EXPECT_EQ(ended.status, 0) << ended.err;
    EXPECT_GT(stopped(), 0);
    EXPECT_NE(case_.text("log").find("Stopped by SIGTERM at t = "), std::string::npos);
}

TEST_F(Steering, TellsAScriptThatTheKeyboardStoppedIt)
{
    const Ended ended = steer("kill -INT $pid");
    EXPECT_EQ(ended.status, 130);
    EXPECT_EQ(ended.err, "");
    EXPECT_GT(stopped(), 0);
    EXPECT_NE(case_.text("log").find("Stopped by SIGINT at t = "), std::string::npos);
}

TEST_F(Steering, WritesAtSigusr1AndGoesOn)
{
    const Ended ended =
        steer("kill -USR1 $pid; while kill -0 $pid && ! ls -d 0.*/uniform > /dev/null 2>&1; do :; done; kill -TERM $pid"
        );
    EXPECT_EQ(ended.status, 0) << ended.err;
    const auto written = times();
    EXPECT_EQ(written.size(), 3u); // the start, at the first signal, at the second
    EXPECT_NE(case_.text("log").find("Stopped by SIGTERM at t = "), std::string::npos);
}

} // namespace
} // namespace slosh
