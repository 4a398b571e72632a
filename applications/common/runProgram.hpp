#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

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

/// Runs a program in `folder` with its output and errors in the file `log` there, and waits for its end. Throws
/// CaseError where it cannot be started.
Ended runProgram(const std::filesystem::path& program, const std::vector<std::string>& arguments,
                 const std::filesystem::path& folder, const std::string& log);

/// The program of that name beside the one that runs, else on the PATH; nothing where there is none.
std::optional<std::filesystem::path> findProgram(const std::string& name);

/// Why a program of this suite failed: the message under its last "--> FOAM FATAL" headline in the log, in one line, or
/// how it ended.
std::string failureOf(const std::filesystem::path& log, const Ended& ended);

} // namespace slosh
