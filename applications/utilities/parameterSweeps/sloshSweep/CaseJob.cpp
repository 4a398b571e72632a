// SPDX-License-Identifier: GPL-3.0-or-later
#include "CaseJob.hpp"

#include "base/writeFile.hpp"
#include "case/Case.hpp"

#include <csignal>
#include <fstream>
#include <iomanip>
#include <iostream>

namespace slosh
{

namespace fs = std::filesystem;

namespace
{

constexpr auto solverLog = "log.sloshSPHFoam";
constexpr auto costSoFar = "costSoFar";

bool wasStopped(const fs::path& log)
{
    std::ifstream in(log);
    for (std::string line; std::getline(in, line);)
    {
        if (line.rfind("Stopped by ", 0) == 0)
        {
            return true;
        }
    }
    return false;
}

bool isEndBySomebody(int status)
{
    return status == 128 + SIGTERM || status == 128 + SIGINT || status == 128 + SIGHUP;
}

/// The log of the call before, under the first name that is free.
void keepLog(const fs::path& log)
{
    for (int k = 1; fs::exists(log); ++k)
    {
        const fs::path kept = log.string() + "." + std::to_string(k);
        if (!fs::exists(kept))
        {
            fs::rename(log, kept);
        }
    }
}

/// The files whose contents differ, for a remark.
std::string changedFiles(const DictionaryFiles& before, const DictionaryFiles& now)
{
    std::string names;
    for (const auto& [file, content] : now)
    {
        const auto old = before.find(file);
        if (old == before.end() || old->second != content)
        {
            names += (names.empty() ? "" : ", ") + file;
        }
    }
    return names.empty() ? "some files are missing" : names;
}

} // namespace

CaseJob::CaseJob(const SweptCase& one, const Sweep& sweep, const RunOptions& options)
    : case_(one), sweep_(sweep), options_(options)
{
    for (const auto* program : {"blockParticles", "sloshSPHFoam", "compareSamples"})
    {
        needProgram(program);
    }
}

void CaseJob::makeAnew()
{
    for (const auto& item : fs::directory_iterator(case_.folder))
    {
        fs::remove_all(item.path());
    }
    for (const auto& [file, content] : case_.files)
    {
        writeFile(case_.folder / file, content);
    }
}

CaseJob::Step CaseJob::firstStep()
{
    fs::create_directories(case_.folder);
    lock_ = std::make_unique<FolderLock>(case_.folder);
    if (!lock_->isOurs())
    {
        return Step::nothing;
    }
    const DictionaryFiles before = readDictionaryFiles(case_.folder);
    if (before != case_.files)
    {
        remark_ = before.empty() ? "" : "repeated, changed: " + changedFiles(before, case_.files);
        makeAnew();
        return Step::fill;
    }
    if (const auto outcome = readOutcome(case_.folder))
    {
        if (outcome->finished())
        {
            return Step::compare;
        }
        if (!options_.retry)
        {
            return Step::nothing;
        }
        outcome_ = *outcome;
        outcome_.failure.clear();
        fs::remove(case_.folder / "cost");
    }
    else if (const auto soFar = readOutcome(case_.folder, costSoFar))
    {
        outcome_ = *soFar;
    }
    const auto times = Case(case_.folder).times();
    if (times.empty() || times.back().value <= 0)
    {
        outcome_ = Outcome();
        makeAnew();
        return Step::fill;
    }
    remark_ = "continued from " + times.back().name + " s";
    return Step::solve;
}

Command CaseJob::command(const std::string& program) const
{
    std::vector<std::string> arguments;
    if (program != "compareSamples")
    {
        arguments = {"-threads", std::to_string(options_.threads)};
    }
    return {needProgram(program), arguments, case_.folder, "log." + program, lock_->descriptor(), true};
}

std::optional<Command> CaseJob::next()
{
    if (step_ == Step::look)
    {
        step_ = firstStep();
    }
    if (step_ == Step::compare)
    {
        if (sweep_.results.empty() || isCompared(case_, sweep_.results))
        {
            return std::nullopt;
        }
        fs::remove(case_.folder / comparisonsName);
        writeFile(case_.folder / comparisonsDictName, comparisonsDict(case_, sweep_.results));
        return command("compareSamples");
    }
    ranAnything_ = ranAnything_ || step_ == Step::fill || step_ == Step::solve;
    if (step_ == Step::solve)
    {
        keepLog(case_.folder / solverLog);
        return command("sloshSPHFoam");
    }
    return step_ == Step::fill ? std::optional(command("blockParticles")) : std::nullopt;
}

void CaseJob::fail(const std::string& why)
{
    outcome_.failure = why;
    writeOutcome(case_.folder, outcome_);
    step_ = Step::nothing;
}

void CaseJob::solved(const Ended& how)
{
    const fs::path log = case_.folder / solverLog;
    outcome_.peakMemory = how.peakMemory;
    readSolverLog(log, outcome_);
    if (isEndBySomebody(how.status) || (how.status == 0 && wasStopped(log)))
    {
        writeOutcome(case_.folder, outcome_, costSoFar);
        step_ = Step::nothing;
    }
    else if (how.status != 0)
    {
        fail(failureOf(log, how));
    }
    else
    {
        fs::remove(case_.folder / costSoFar);
        writeOutcome(case_.folder, outcome_);
        step_ = Step::compare;
    }
}

void CaseJob::ended(const Ended& how)
{
    if (step_ == Step::compare)
    {
        step_ = Step::nothing; // readState tells what its log says
        return;
    }
    outcome_.threads = options_.threads;
    outcome_.cpuSeconds += how.cpuSeconds;
    outcome_.wallSeconds += how.wallSeconds;
    if (step_ == Step::solve)
    {
        solved(how);
    }
    else if (how.status == 0)
    {
        step_ = Step::solve;
    }
    else if (isEndBySomebody(how.status))
    {
        step_ = Step::nothing;
    }
    else
    {
        fail(failureOf(case_.folder / "log.blockParticles", how));
    }
}

void CaseJob::broken(const std::string& why)
{
    trouble_ = why;
}

void CaseJob::done()
{
    const bool isOurs = lock_ && lock_->isOurs();
    lock_.reset();
    const CaseState state = readState(case_, sweep_.results);
    std::cout << "[" << case_.number << "/" << sweep_.cases.size() << "] " << case_.setting.name << ": ";
    if (!trouble_.empty())
    {
        std::cout << "not run: " << trouble_ << "\n" << std::flush;
        return;
    }
    std::cout << state.word() << (state.reason().empty() ? "" : ": " + state.reason());
    if (state.stage == CaseState::Stage::finished)
    {
        std::cout << ", " << std::setprecision(3) << state.outcome.cpuSeconds << " s of CPU";
    }
    std::cout << (ranAnything_ || !isOurs ? "" : " (finished earlier)") << (remark_.empty() ? "" : " (" + remark_ + ")")
              << "\n"
              << std::flush;
}

} // namespace slosh
