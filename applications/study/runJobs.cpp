// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/runJobs.hpp"

#include <sys/resource.h>
#include <sys/wait.h>

#include <csignal>
#include <map>

namespace slosh
{

namespace
{

/// Signals wait until they are asked for: none is lost between two looks.
class HeldSignals
{
public:
    HeldSignals()
    {
        sigemptyset(&held_);
        sigaddset(&held_, SIGCHLD);
        for (const int signal : {SIGTERM, SIGINT, SIGHUP})
        {
            struct sigaction now = {};
            sigaction(signal, nullptr, &now);
            if (now.sa_handler != SIG_IGN) // nohup, or a shell that runs this in the background
            {
                sigaddset(&held_, signal);
            }
        }
        sigprocmask(SIG_BLOCK, &held_, &before_);
    }
    ~HeldSignals() { sigprocmask(SIG_SETMASK, &before_, nullptr); }
    HeldSignals(const HeldSignals&) = delete;
    HeldSignals& operator=(const HeldSignals&) = delete;

    int next() const { return sigwaitinfo(&held_, nullptr); }

private:
    sigset_t held_{}, before_{};
};

using Clock = std::chrono::steady_clock;

struct Running
{
    Job* job = nullptr;
    Clock::time_point begin;
};

using AllRunning = std::map<pid_t, Running>;

/// Starts the job's next command, or it is done.
void goOn(Job& job, bool stopping, AllRunning& running)
{
    try
    {
        if (auto command = stopping ? std::nullopt : job.next())
        {
            command->inOwnGroup = true;
            const auto begin = Clock::now();
            running[startProgram(*command)] = {&job, begin};
            return;
        }
    }
    catch (const std::exception& failure)
    {
        job.broken(failure.what());
    }
    job.done();
}

/// Takes leave of those that have ended, and starts what their jobs want next.
void reap(AllRunning& running, bool stopping)
{
    for (auto it = running.begin(); it != running.end();)
    {
        int status = 0;
        rusage usage{};
        if (wait4(it->first, &status, WNOHANG, &usage) != it->first)
        {
            ++it;
            continue;
        }
        const Running one = it->second;
        it = running.erase(it);
        one.job->ended(endedBy(status, usage, one.begin));
        goOn(*one.job, stopping, running);
    }
}

} // namespace

int runJobs(const std::vector<std::unique_ptr<Job>>& jobs, std::size_t atOnce)
{
    const HeldSignals signals;
    AllRunning running;
    std::size_t next = 0;
    int stop = 0;
    for (;;)
    {
        while (stop == 0 && next < jobs.size() && running.size() < atOnce)
        {
            goOn(*jobs[next++], false, running);
        }
        if (running.empty())
        {
            return stop;
        }
        const int signal = signals.next();
        if (signal == SIGCHLD)
        {
            reap(running, stop != 0);
        }
        else if (signal > 0)
        {
            stop = stop == 0 ? signal : stop;
            for (const auto& one : running)
            {
                kill(one.first, SIGTERM);
            }
        }
    }
}

} // namespace slosh
