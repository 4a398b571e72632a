// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <sys/types.h>

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

struct rusage;

namespace slosh
{

/// How a program ended and what it took, by wait4.
struct Ended
{
    int status = 0;        ///< exit status; 128 + signal where one ended it
    double cpuSeconds = 0; ///< user and system, of all threads
    double wallSeconds = 0;
    double peakMemory = 0; ///< resident, [MB]; Linux counts the few MB of the program that started it as a least
};

/// A program to be run in `folder`, its output and errors in the file `log` there.
struct Command
{
    std::filesystem::path program;
    std::vector<std::string> arguments;
    std::filesystem::path folder;
    std::string log;
    int lock = -1;           ///< a descriptor that it keeps open, so that a lock lasts as long as it runs; -1: none
    bool inOwnGroup = false; ///< the terminal's control-C does not reach it, and no signal is blocked in it
};

/// Starts it. Throws CaseError where it cannot be started.
pid_t startProgram(const Command& command);

/// What wait4 has told of a program that was started at `begin`.
Ended endedBy(int status, const rusage& usage, std::chrono::steady_clock::time_point begin);

/// Runs a program in `folder` with its output and errors in the file `log` there, and waits for its end. Throws
/// CaseError where it cannot be started.
Ended runProgram(
    const std::filesystem::path& program, const std::vector<std::string>& arguments,
    const std::filesystem::path& folder, const std::string& log
);

/// The program of that name beside the one that runs, else on the PATH; nothing where there is none.
std::optional<std::filesystem::path> findProgram(const std::string& name);
/// The same; throws CaseError where there is none.
std::filesystem::path needProgram(const std::string& name);

/// Why a program of this suite failed: the message under its last "--> FOAM FATAL" headline in the log, in one line, or
/// how it ended.
std::string failureOf(const std::filesystem::path& log, const Ended& ended);

} // namespace slosh
