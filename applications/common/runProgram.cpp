// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/runProgram.hpp"

#include "base/CaseError.hpp"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>
#include <sstream>

namespace slosh
{

namespace fs = std::filesystem;

namespace
{

double seconds(const timeval& time)
{
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

/// The attributes and file actions of a start, freed with it.
struct Spawning
{
    Spawning()
    {
        posix_spawnattr_init(&attributes);
        posix_spawn_file_actions_init(&actions);
    }
    ~Spawning()
    {
        posix_spawn_file_actions_destroy(&actions);
        posix_spawnattr_destroy(&attributes);
    }
    Spawning(const Spawning&) = delete;
    Spawning& operator=(const Spawning&) = delete;

    posix_spawnattr_t attributes{};
    posix_spawn_file_actions_t actions{};
};

} // namespace

pid_t startProgram(const Command& command)
{
    std::string name = command.program.string();
    std::vector<std::string> copies = command.arguments;
    std::vector<char*> argv{name.data()};
    argv.reserve(copies.size() + 2);
    for (auto& argument : copies)
    {
        argv.push_back(argument.data());
    }
    argv.push_back(nullptr);

    Spawning with;
    posix_spawn_file_actions_addchdir_np(&with.actions, command.folder.c_str());
    posix_spawn_file_actions_addopen(
        &with.actions, STDOUT_FILENO, command.log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666
    );
    posix_spawn_file_actions_adddup2(&with.actions, STDOUT_FILENO, STDERR_FILENO);
    if (command.lock >= 0)
    {
        posix_spawn_file_actions_adddup2(&with.actions, command.lock, command.lock); // no longer closed on exec
    }
    if (command.inOwnGroup)
    {
        sigset_t none;
        sigemptyset(&none);
        posix_spawnattr_setflags(&with.attributes, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGMASK);
        posix_spawnattr_setpgroup(&with.attributes, 0);
        posix_spawnattr_setsigmask(&with.attributes, &none);
    }
    pid_t pid = 0;
    const int failure = posix_spawn(&pid, name.c_str(), &with.actions, &with.attributes, argv.data(), environ);
    if (failure != 0)
    {
        throw CaseError("cannot run " + name + " in " + command.folder.string() + ": " + std::strerror(failure));
    }
    return pid;
}

Ended endedBy(int status, const rusage& usage, std::chrono::steady_clock::time_point begin)
{
    const std::chrono::duration<double> clock = std::chrono::steady_clock::now() - begin;
    return {
        WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status),
        seconds(usage.ru_utime) + seconds(usage.ru_stime), clock.count(),
        static_cast<double>(usage.ru_maxrss) * 1024 / 1e6};
}

Ended runProgram(
    const fs::path& program, const std::vector<std::string>& arguments, const fs::path& folder, const std::string& log
)
{
    const auto begin = std::chrono::steady_clock::now();
    const pid_t pid = startProgram({program, arguments, folder, log});
    int status = 0;
    rusage usage{};
    while (wait4(pid, &status, 0, &usage) < 0)
    {
        if (errno != EINTR)
        {
            throw CaseError("cannot wait for " + program.string() + ": " + std::strerror(errno));
        }
    }
    return endedBy(status, usage, begin);
}

std::optional<fs::path> findProgram(const std::string& name)
{
    std::error_code failure;
    std::string folders = fs::read_symlink("/proc/self/exe", failure).parent_path().string();
    if (const char* path = std::getenv("PATH"))
    {
        folders += ":" + std::string(path);
    }
    std::istringstream all(folders);
    for (std::string folder; std::getline(all, folder, ':');)
    {
        const fs::path program = fs::path(folder.empty() ? "." : folder) / name;
        if (fs::is_regular_file(program, failure) && access(program.c_str(), X_OK) == 0)
        {
            return fs::absolute(program);
        }
    }
    return std::nullopt;
}

fs::path needProgram(const std::string& name)
{
    const auto program = findProgram(name);
    if (!program)
    {
        std::error_code failure;
        throw CaseError(
            name + " is neither beside " + fs::read_symlink("/proc/self/exe", failure).filename().string() +
            " nor on the PATH"
        );
    }
    return *program;
}

std::string failureOf(const fs::path& log, const Ended& ended)
{
    if (ended.status > 128)
    {
        return "ended by signal " + std::to_string(ended.status - 128);
    }
    std::ifstream in(log);
    const std::string text(std::istreambuf_iterator<char>(in), {});
    const auto headline = text.rfind("--> FOAM FATAL");
    const auto begin = headline == std::string::npos ? headline : text.find('\n', headline);
    std::string message;
    if (begin != std::string::npos)
    {
        for (std::istringstream words(text.substr(begin)); words;)
        {
            std::string word;
            words >> word;
            message += (message.empty() || word.empty() ? "" : " ") + word;
        }
    }
    return message.empty() ? "exit status " + std::to_string(ended.status) : message;
}

} // namespace slosh
