// SPDX-License-Identifier: GPL-3.0-or-later
// Runs a case at many values of its entries, several runs at a time; can be stopped and continued; writes a table and a
// map.
#include "CaseJob.hpp"
#include "Ensemble.hpp"
#include "common/Program.hpp"
#include "map.hpp"
#include "slurmScript.hpp"
#include "table.hpp"

#include "base/counted.hpp"
#include "base/threads.hpp"
#include "base/writeFile.hpp"
#include "case/Case.hpp"

#include <algorithm>
#include <charconv>
#include <csignal>
#include <iostream>

using namespace slosh;

namespace
{

namespace fs = std::filesystem;

struct Wanted
{
    std::string dict = "system/sweepDict";
    long jobs = 0;       ///< 0: not said
    long caseNumber = 0; ///< 0: all
    bool dryRun = false, collect = false, slurm = false, retry = false;
};

long wholeNumber(const Program& program, const std::string& option, long otherwise, long most)
{
    if (!program.has(option))
    {
        return otherwise;
    }
    const std::string text = program.value(option);
    long number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc() || end != text.data() + text.size() || number < 1 || number > most)
    {
        throw CaseError("-" + option + " is " + text + "; expected a whole number from 1 to " + std::to_string(most));
    }
    return number;
}

std::vector<CaseState> statesOf(const Sweep& sweep)
{
    std::vector<CaseState> states;
    states.reserve(sweep.cases.size());
    for (const SweptCase& one : sweep.cases)
    {
        states.push_back(readState(one, sweep.results));
    }
    return states;
}

/// Runs what is asked for; returns the signal that stopped it, or 0.
int runCases(const Sweep& sweep, const Wanted& wanted)
{
    const bool isOne = wanted.caseNumber > 0;
    const long count = isOne ? 1 : std::ssize(sweep.cases);
    const long processors = threads();
    const long jobs = isOne ? 1 : std::min(count, wanted.jobs > 0 ? wanted.jobs : processors);
    const RunOptions options{std::max(1L, processors / jobs), wanted.retry};
    std::cout << (isOne ? "Case " + std::to_string(wanted.caseNumber) + " of " : "")
              << counted(sweep.cases.size(), "case") << ", " << jobs
              << " at a time, threads of each: " << options.threads << "\n\n"
              << std::flush;
    std::vector<std::unique_ptr<Job>> all;
    for (const SweptCase& one : sweep.cases)
    {
        if (!isOne || one.number == wanted.caseNumber)
        {
            all.push_back(std::make_unique<CaseJob>(one, sweep, options));
        }
    }
    const int signal = runJobs(all, static_cast<std::size_t>(jobs));
    if (signal != 0)
    {
        std::cout << "\nStopped by signal " << signal << "; run it again to continue the sweep\n";
    }
    return signal;
}

void draw(const fs::path& folder, const std::string& script)
{
    if (script.empty())
    {
        std::cout << "No map: no case has a result\n";
        return;
    }
    writeFile(folder / "sweep.gp", script);
    const auto gnuplot = findProgram("gnuplot");
    if (!gnuplot)
    {
        std::cout << "No map: gnuplot is not on the PATH; sweep.gp draws it\n";
        return;
    }
    const Ended ended = runProgram(*gnuplot, {"sweep.gp"}, folder, "log.gnuplot");
    std::cout
        << (ended.status == 0 ? "Wrote sweep.svg, sweep.png\n"
                              : "--> FOAM Warning: no map, gnuplot failed: see log.gnuplot\n");
}

/// Throws CaseError where not all is done that should be.
void requireComplete(const std::vector<CaseState>& states, const Sweep& sweep)
{
    std::string missing;
    long count = 0;
    for (std::size_t i = 0; i < states.size(); ++i)
    {
        if (!states[i].isComplete())
        {
            ++count;
            missing += "\n    " + sweep.cases[i].setting.name + ": " + states[i].word() +
                       (states[i].reason().empty() ? "" : ": " + states[i].reason());
        }
    }
    if (count > 0)
    {
        throw CaseError(
            std::to_string(count) + " of " + counted(states.size(), "case") +
            (count == 1 ? " has no result:" : " have no result:") + missing
        );
    }
}

/// Returns the signal that stopped it, or 0.
int sloshSweep(const Case& theCase, const Wanted& wanted)
{
    DictionaryFiles files = readDictionaryFiles(theCase.root());
    files.erase(wanted.dict); // the sweep is not part of the case
    const fs::path folder = theCase.root() / "postProcessing/sweep/0";
    const Sweep sweep = Sweep::read(theCase.dictionary(wanted.dict), files, folder / "runs");
    if (wanted.caseNumber > std::ssize(sweep.cases))
    {
        throw CaseError(
            "-only is " + std::to_string(wanted.caseNumber) + "; expected a case from 1 to " +
            std::to_string(sweep.cases.size())
        );
    }
    if (wanted.dryRun)
    {
        std::cout << casesText(sweep, statesOf(sweep)) << "Nothing is run: -dry-run\n";
        return 0;
    }
    if (wanted.slurm)
    {
        writeFile(theCase.root() / "sweep.sbatch", slurmScript(sweep, theCase.root(), wanted.dict, wanted.jobs));
        std::cout << "Wrote sweep.sbatch, an array of " << counted(sweep.cases.size(), "task")
                  << ": sbatch sweep.sbatch; then sloshSweep -collect\n";
        return 0;
    }
    const int signal = wanted.collect ? 0 : runCases(sweep, wanted);
    const std::vector<CaseState> states = statesOf(sweep);
    if (wanted.caseNumber > 0)
    {
        // The table belongs to all: many tasks would write it at once.
        const auto k = static_cast<std::size_t>(wanted.caseNumber - 1);
        if (signal == 0 && !states[k].isComplete())
        {
            throw CaseError(sweep.cases[k].setting.name + " " + states[k].word() + ": " + states[k].reason());
        }
        return signal;
    }
    writeFile(folder / "sweep.tsv", tableText(sweep, states));
    std::cout << "\nIn " << folder.lexically_relative(theCase.root()).string() << "\nWrote sweep.tsv\n";
    if (!sweep.memberAxes.empty())
    {
        const auto ensembles = ensemblesOf(sweep, states);
        writeFile(folder / "ensemble.tsv", ensembleTable(sweep, ensembles));
        std::cout << "Wrote ensemble.tsv\n" << ensembleText(sweep, ensembles) << sameMembers(sweep, states);
    }
    draw(folder, mapScript(theCase.name(), sweep, states));
    if (signal == 0)
    {
        requireComplete(states, sweep);
    }
    return signal;
}

} // namespace

int main(int argc, char** argv)
{
    Program program(
        "sloshSweep", "Parameter sweeps: runs a case for the values in system/sweepDict and writes a table and a map.",
        "sloshSweep -case tutorials/swayingTank/response -jobs 2"
    );
    program.addThreads();
    program.addOption("dict", "file", "the sweep; default: system/sweepDict");
    program.addOption("jobs", "n", "number of concurrent cases, which share the threads; default: one per thread");
    program.addOption("dry-run", "", "read and check the sweep, list its cases and natural frequencies, write nothing");
    program.addOption("retry", "", "continue failed cases from their last time");
    program.addOption("collect", "", "run nothing: write table and map of the finished cases");
    program.addOption("slurm", "", "run nothing: write sweep.sbatch, a job array with one task per case for a cluster");
    program.addOption("only", "n", "run this case only, without table and map, as a task of the array");
    program.addFile("system/sweepDict", "read: the parameters to vary and the results");
    program.addFile("postProcessing/sweep/0/", "written: runs/, sweep.tsv, .gp, .svg, .png, ensemble.tsv");
    program.addFile("sweep.sbatch", "written by -slurm");
    program.addDictionary(
        {"system/sweepDict",
         "The parameters that sloshSweep varies and the results that it tabulates. For each combination sloshSweep "
         "copies the dictionaries of the case to a folder below postProcessing/sweep/0/runs and runs blockParticles, "
         "sloshSPHFoam and compareSamples there, several cases at a time. It writes postProcessing/sweep/0/sweep.tsv "
         "(one row per case), sweep.svg and sweep.png (a line, a colour map or curves) and, for ensembles, "
         "ensemble.tsv.\n"
         "A second start continues the sweep: finished cases are kept, and stopped cases continue from their last time "
         "(sloshSweep sets startFrom latestTime in each case). A case whose dictionaries have changed is run again "
         "from the beginning. Files in system/ whose names begin with sweep, comparisons, peakStatistics or "
         "workPrecision are not copied.",
         sweepDictKeys}
    );
    program.addVariable("SLOSH_MEASURED", "folder of measured records");
    int signal = 0;
    const int status = program.run(
        argc, argv,
        [&]
        {
            Wanted wanted;
            wanted.dict = program.has("dict") ? program.value("dict") : wanted.dict;
            wanted.jobs = wholeNumber(program, "jobs", 0, 1024);
            wanted.caseNumber = wholeNumber(program, "only", 0, 1000000);
            wanted.dryRun = program.has("dry-run");
            wanted.collect = program.has("collect");
            wanted.slurm = program.has("slurm");
            wanted.retry = program.has("retry");
            signal = sloshSweep(Case(program.caseFolder()), wanted);
        }
    );
    // A sweep that was stopped is not complete: what follows in a script is not to be started.
    return status == 0 && signal != 0 ? 128 + signal : status;
}
