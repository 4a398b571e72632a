// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "common/runProgram.hpp"

#include <cstddef>
#include <memory>
#include <vector>

namespace slosh
{

/// Programs that are to run one after the other, each chosen when the one before has ended.
class Job
{
public:
    virtual ~Job() = default;

    /// What to run now; nothing where the job is done. Its command is run in a group of its own.
    virtual std::optional<Command> next() = 0;
    /// How the last one ended.
    virtual void ended(const Ended& how) = 0;
    /// The job cannot go on: what next() or starting its command has thrown.
    virtual void broken(const std::string& why) = 0;
    /// Its last call: nothing of it is run any more.
    virtual void done() = 0;
};

/// Runs the jobs in their order, `atOnce` at a time. SIGTERM, SIGINT and SIGHUP, unless they were ignored, are handed
/// to what runs as SIGTERM, each time one comes; after the first nothing is started any more. Returns that signal, or
/// 0.
int runJobs(const std::vector<std::unique_ptr<Job>>& jobs, std::size_t atOnce);

} // namespace slosh
