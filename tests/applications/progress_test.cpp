// SPDX-License-Identifier: GPL-3.0-or-later
// The line of progress: on a terminal (that of script, package bsdutils), not in a file or a pipe.
#include "CaseDirectory.hpp"

#include <gtest/gtest.h>

#include <filesystem>

namespace slosh
{
namespace
{

namespace fs = std::filesystem;

const std::string line = " %  t = ";
const std::string takenOff = "\r\033[K";

std::size_t count(const std::string& text, const std::string& words)
{
    std::size_t times = 0;
    for (auto at = text.find(words); at != std::string::npos; at = text.find(words, at + 1))
    {
        ++times;
    }
    return times;
}

/// A case that would run for some seconds.
class Progress : public testing::Test
{
protected:
    Progress()
    {
        case_.edit("system/controlDict", "endTime 0.1;", "endTime 40;");
        case_.edit("system/controlDict", "writeInterval 0.05;", "writeInterval 100;");
        case_.succeed("blockParticles");
    }

    /// The solver on a terminal of `columns`, its standard output to `output` (empty: the terminal) until the line has
    /// been there `times` times; then SIGTERM. What the terminal got.
    std::string onTerminal(int columns, const std::string& output, int times = 2) const
    {
        case_.write(
            "solve", "stty cols " + std::to_string(columns) +
                         "; echo $$ > pid; exec " SLOSH_BIN "/sloshSPHFoam -threads 1 " + output + "\n"
        );
        case_.write(
            "show", "#!/bin/bash\nset -o pipefail\nexport TERM=xterm\n"
                    "script -qec 'bash solve' /dev/null < /dev/null | tee terminal | stdbuf -oL tr '\\r' '\\n' |\n"
                    "{ grep -m " +
                        std::to_string(times) + " '" + line + "'; kill -TERM $(cat pid); cat > rest; }\n"
        );
        fs::permissions(case_.path() / "show", fs::perms::owner_exec, fs::perm_options::add);
        const Ended ended = case_.run("./show");
        EXPECT_EQ(ended.status, 0) << ended.out << ended.err;
        return case_.text("terminal");
    }

    const CaseDirectory case_;
};

TEST_F(Progress, IsShownOnATerminalAndTakenOffBeforeAnythingElseIsSaid)
{
    const std::string terminal = onTerminal(120, "");
    EXPECT_GE(count(terminal, line), 2u);
    for (const std::string words : {" of 40 s  left ", "  dt = ", "  outside 0  stopped at walls "})
    {
        EXPECT_NE(terminal.find(words), std::string::npos) << words;
    }
    // Every line of progress is overwritten, by the next or by nothing; none is left when it ends.
    const auto last = terminal.rfind(line);
    EXPECT_NE(terminal.find(takenOff, last), std::string::npos);
    for (auto at = terminal.find(line); at != std::string::npos; at = terminal.find(line, at + 1))
    {
        const auto end = terminal.find("\033[K", at) + 3;
        EXPECT_EQ(terminal[end], '\r');
        EXPECT_NE(terminal[end + 1], '\n');
    }
    EXPECT_NE(terminal.find("Time = "), std::string::npos);
    EXPECT_NE(terminal.find("End\r\n", last), std::string::npos);
}

TEST_F(Progress, SaysHowLongItWillTakeOnceItHasRunForASecond)
{
    const std::string terminal = onTerminal(120, "", 8);
    EXPECT_NE(terminal.find("left ? "), std::string::npos);
    const auto left = terminal.find("  left ", terminal.rfind("left ? ") + 1);
    ASSERT_NE(left, std::string::npos);
    EXPECT_GT(std::stod(terminal.substr(left + 7)), 0);
}

TEST_F(Progress, IsShownBesideALogFileThatHoldsNothingOfIt)
{
    const std::string terminal = onTerminal(120, "> log");
    EXPECT_GE(count(terminal, line), 2u);
    EXPECT_EQ(count(terminal, "Time = "), 0u);
    const std::string log = case_.text("log");
    EXPECT_NE(log.find("Time = "), std::string::npos);
    EXPECT_EQ(log.find_first_of("\r\033"), std::string::npos);
    EXPECT_EQ(count(log, line), 0u);
}

TEST_F(Progress, IsNoLongerThanTheTerminal)
{
    const std::string terminal = onTerminal(30, "> log");
    for (auto at = terminal.find(line); at != std::string::npos; at = terminal.find(line, at + 1))
    {
        const auto begin = terminal.rfind('\r', at) + 1;
        EXPECT_EQ(terminal.find("\033[K", at) - begin, 29u);
    }
}

TEST_F(Progress, IsNotInAPipe)
{
    case_.edit("system/controlDict", "endTime 40;", "endTime 2;");
    const std::string log = case_.succeed("sloshSPHFoam -threads 1");
    EXPECT_NE(log.find("Time = "), std::string::npos);
    EXPECT_EQ(log.find_first_of("\r\033"), std::string::npos);
}

} // namespace
} // namespace slosh
