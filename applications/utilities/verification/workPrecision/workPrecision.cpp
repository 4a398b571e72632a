// SPDX-License-Identifier: GPL-3.0-or-later
// Error against run time: a case at many settings, one after another, each with what it cost and how far it is off.
#include "Run.hpp"
#include "Study.hpp"
#include "common/Program.hpp"
#include "common/runProgram.hpp"
#include "diagram.hpp"
#include "summary.hpp"
#include "tableText.hpp"

#include "base/counted.hpp"
#include "base/writeFile.hpp"
#include "case/Case.hpp"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <iostream>

using namespace slosh;

namespace
{

namespace fs = std::filesystem;

/// The run whose samples are the reference of `run`; null: there is none.
const Run* referenceOf(const Run& run, const Comparison& comparison, const std::vector<Run>& runs)
{
    const Run* reference = nullptr;
    for (const Run& other : runs)
    {
        const bool isCandidate =
            comparison.reference == Comparison::Reference::run
                ? other.setting.name == comparison.run
                : comparison.reference == Comparison::Reference::finest && other.setting.scheme == run.setting.scheme;
        if (isCandidate && other.outcome.finished() &&
            (reference == nullptr || other.outcome.spacing < reference->outcome.spacing))
        {
            reference = &other;
        }
    }
    return reference;
}

void report(const Run& run, bool isEarlier)
{
    std::cout << run.setting.name << ": " << std::setprecision(4);
    if (run.outcome.finished())
    {
        std::cout << run.outcome.cpuSeconds << " s of CPU, " << run.outcome.particles << " particles, "
                  << run.outcome.steps << " steps";
    }
    else
    {
        std::cout << "failed: " << run.outcome.failure;
    }
    std::cout << (isEarlier ? " (finished earlier)" : "") << "\n" << std::flush;
}

void runAll(std::vector<Run>& runs, const DictionaryFiles& files, const Study& study, const Programs& programs)
{
    bool comparisonsTried = false;
    for (Run& run : runs)
    {
        const DictionaryFiles wanted = withEdits(files, run.setting.edits, "workPrecision");
        const bool isEarlier = takeEarlierOutcome(run, wanted, study.threads);
        if (!isEarlier)
        {
            perform(run, wanted, study.threads, programs);
        }
        report(run, isEarlier);
        // What is wrong with the comparisons shows now and not after hours: the run is held against itself.
        if (!isEarlier && run.outcome.finished() && !comparisonsTried)
        {
            compare(run, study.comparisons, std::vector<const Run*>(study.comparisons.size(), &run), programs);
            comparisonsTried = true;
        }
    }
}

/// Adds those runs of other programs that somebody has made.
void takeOutside(
    std::vector<Run>& runs, const Study& study, const DictionaryFiles& files, const fs::path& root,
    const fs::path& folder
)
{
    for (const OutsideRun& outside : study.outside)
    {
        Run run;
        run.setting.name = outside.name;
        run.setting.scheme = run.setting.family = outside.program;
        run.folder = folder / "runs" / outside.name;
        if (!takeOutsideRun(outside, root, files, run))
        {
            std::cout << outside.name << ": omitted, " << outside.folder.string() << " has no file 'cost'\n";
            continue;
        }
        report(run, true);
        runs.push_back(run);
    }
}

void compareAll(std::vector<Run>& runs, const Study& study, const Programs& programs)
{
    for (Run& run : runs)
    {
        if (run.outcome.finished())
        {
            std::vector<const Run*> references;
            references.reserve(study.comparisons.size());
            for (const auto& comparison : study.comparisons)
            {
                references.push_back(referenceOf(run, comparison, runs));
            }
            compare(run, study.comparisons, references, programs);
        }
    }
}

void draw(const fs::path& folder, const std::string& script)
{
    if (script.empty())
    {
        std::cout << "No diagram: there is no error to draw; the reason is above and in summary.txt\n";
        return;
    }
    writeFile(folder / "workPrecision.gp", script);
    const auto gnuplot = findProgram("gnuplot");
    if (!gnuplot)
    {
        std::cout << "No diagram: gnuplot is not on the PATH; workPrecision.gp draws it\n";
        return;
    }
    const Ended ended = runProgram(*gnuplot, {"workPrecision.gp"}, folder, "log.gnuplot");
    std::cout
        << (ended.status == 0 ? "Wrote workPrecision.svg, workPrecision.png\n"
                              : "--> FOAM Warning: no diagram, gnuplot failed: see log.gnuplot\n");
}

void workPrecision(const Case& theCase, const std::string& dictName, bool dryRun)
{
    DictionaryFiles files = readDictionaryFiles(theCase.root());
    files.erase(dictName); // the study is not part of the case
    const Study study = Study::read(theCase.dictionary(dictName), files);
    if (dryRun)
    {
        for (const Setting& setting : study.settings)
        {
            std::cout << setting.name << "\n";
        }
        std::cout << "Nothing is run: -dry-run\n";
        return;
    }
    const Programs programs = Programs::find();
    const fs::path folder = theCase.root() / "postProcessing/workPrecision/0";

    std::vector<Run> runs;
    runs.reserve(study.settings.size());
    for (const Setting& setting : study.settings)
    {
        runs.push_back({setting, folder / "runs" / setting.name, {}, {}});
    }
    std::cout << counted(runs.size(), "run") << " below "
              << (folder / "runs").lexically_relative(theCase.root()).string()
              << ", one after another, threads: " << study.threads << "\n\n";
    runAll(runs, files, study, programs);
    takeOutside(runs, study, files, theCase.root(), folder);
    compareAll(runs, study, programs);

    std::vector<ErrorTable> tables;
    tables.reserve(study.comparisons.size());
    for (std::size_t k = 0; k < study.comparisons.size(); ++k)
    {
        tables.push_back(errorTable(runs, study.comparisons, k, study.formalOrder));
    }
    const std::string table = alignedText(theCase.name(), tables), summary = summaryText(study, runs, tables);
    writeFile(folder / "workPrecision.csv", csvText(theCase.name(), tables));
    writeFile(folder / "workPrecision.dat", table);
    writeFile(folder / "summary.txt", summary);
    std::cout << "\n"
              << summary << "\nIn " << folder.lexically_relative(theCase.root()).string() << "\n"
              << "Wrote workPrecision.csv, workPrecision.dat, summary.txt\n";
    draw(folder, diagramScript(theCase.name(), study, tables));
}

} // namespace

int main(int argc, char** argv)
{
    Program program(
        "workPrecision", "Error against run time: runs a case at the settings of system/workPrecisionDict.",
        "workPrecision -case tutorials/stretchingPatch/cao2014 "
        "-dict ../../workPrecision/patch/system/workPrecisionDict"
    );
    program.addOption("dict", "file", "the study; default: system/workPrecisionDict");
    program.addOption("dry-run", "", "read and check the study, list its runs, write nothing");
    program.addFile("system/workPrecisionDict", "read: the parameters to vary and the error measures");
    program.addFile(
        "postProcessing/workPrecision/0/", "written: runs/, workPrecision.csv, .dat, .svg, .png, summary.txt"
    );
    program.addDictionary(
        {"system/workPrecisionDict",
         "Parameters varied and errors measured by workPrecision. It copies the dictionaries of the case once for each "
         "setting, below postProcessing/workPrecision/0/runs, runs blockParticles, sloshSPHFoam and compareSamples "
         "there, one after another, and writes into postProcessing/workPrecision/0: workPrecision.csv and .dat (a row "
         "for each run and comparison), summary.txt, workPrecision.svg and .png. CPU seconds are those of "
         "blockParticles, which settles the liquid, and sloshSPHFoam together.\nA run whose dictionaries are unchanged "
         "is not repeated; a failed run is marked in its row until its folder is removed.",
         workPrecisionDictKeys}
    );
    program.addVariable("SLOSH_MEASURED", "folder of measured records");
    return program.run(
        argc, argv,
        [&]
        {
            workPrecision(
                Case(program.caseFolder()), program.has("dict") ? program.value("dict") : "system/workPrecisionDict",
                program.has("dry-run")
            );
        }
    );
}
