// SPDX-License-Identifier: GPL-3.0-or-later
#include "Run.hpp"

#include "common/runProgram.hpp"

#include "base/writeFile.hpp"
#include "case/foamFile.hpp"
#include "dictionary/tokenize.hpp"

#include <cmath>
#include <fstream>
#include <iterator>
#include <sstream>

namespace slosh
{

namespace fs = std::filesystem;

namespace
{

constexpr auto compareLog = "log.compareSamples";
constexpr auto comparisonsDict = "system/comparisonsDict";
constexpr auto comparisonsFile = "postProcessing/compareSamples/comparisons.dat";

std::string textOf(const fs::path& file)
{
    std::ifstream in(file, std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(in), {});
}

/// Runs compareSamples; "" or why it failed.
std::string runCompareSamples(const Run& run, const Programs& programs)
{
    const Ended ended = runProgram(programs.compareSamples, {}, run.folder, compareLog);
    if (ended.status == 0)
    {
        return "";
    }
    const std::string failure = failureOf(run.folder / compareLog, ended);
    if (textOf(run.folder / compareLog).find("--> FOAM FATAL IO ERROR") != std::string::npos)
    {
        throw CaseError(failure + "\n(compareSamples in " + run.folder.string() + ")", CaseError::Kind::input);
    }
    return failure;
}

void readCompared(Run& run, const std::vector<Comparison>& comparisons, const std::vector<const Run*>& references)
{
    std::istringstream lines(textOf(run.folder / comparisonsFile));
    for (std::string line; std::getline(lines, line);)
    {
        std::istringstream words(line);
        std::string name, figure, error, expected, standardError, expectedError;
        std::size_t count = 0;
        words >> name >> figure >> error >> expected >> standardError >> expectedError >> count;
        for (std::size_t k = 0; k < comparisons.size(); ++k)
        {
            if (comparisons[k].name == name)
            {
                Compared& compared = run.compared[k];
                isNumber(figure, compared.figure); // nan is none
                isNumber(error, compared.error);
                isNumber(standardError, compared.standardError);
                compared.count = count;
                // The distance of a reference from itself is no error.
                compared.error = references[k] == &run ? Outcome::unknown : std::abs(compared.error);
            }
        }
    }
}

} // namespace

Programs Programs::find()
{
    return {needProgram("blockParticles"), needProgram("sloshSPHFoam"), needProgram("compareSamples")};
}

bool takeEarlierOutcome(Run& run, const DictionaryFiles& files, long threads)
{
    const auto earlier = readOutcome(run.folder);
    if (!earlier || earlier->threads != threads || readDictionaryFiles(run.folder) != files)
    {
        return false;
    }
    run.outcome = *earlier;
    return true;
}

void perform(Run& run, const DictionaryFiles& files, long threads, const Programs& programs)
{
    fs::remove_all(run.folder);
    for (const auto& [file, content] : files)
    {
        writeFile(run.folder / file, content);
    }
    run.outcome = Outcome();
    run.outcome.threads = threads;
    const std::vector<std::string> threaded{"-threads", std::to_string(threads)};

    Ended ended = runProgram(programs.blockParticles, threaded, run.folder, "log.blockParticles");
    run.outcome.cpuSeconds = ended.cpuSeconds;
    run.outcome.wallSeconds = ended.wallSeconds;
    if (ended.status != 0)
    {
        run.outcome.failure = failureOf(run.folder / "log.blockParticles", ended);
    }
    else
    {
        ended = runProgram(programs.sloshSPHFoam, threaded, run.folder, "log.sloshSPHFoam");
        run.outcome.cpuSeconds += ended.cpuSeconds;
        run.outcome.wallSeconds += ended.wallSeconds;
        run.outcome.peakMemory = ended.peakMemory;
        readSolverLog(run.folder / "log.sloshSPHFoam", run.outcome);
        if (ended.status != 0)
        {
            run.outcome.failure = failureOf(run.folder / "log.sloshSPHFoam", ended);
        }
    }
    writeOutcome(run.folder, run.outcome);
}

void compare(
    Run& run, const std::vector<Comparison>& comparisons, const std::vector<const Run*>& references,
    const Programs& programs
)
{
    run.compared.assign(comparisons.size(), {});
    std::string dictionary = foamHeader("dictionary", "system", "comparisonsDict");
    auto lastEnd = fs::last_write_time(run.folder / "cost");
    for (std::size_t k = 0; k < comparisons.size(); ++k)
    {
        if (comparisons[k].needsRun() && references[k] == nullptr)
        {
            continue; // the run that should be the reference has failed
        }
        dictionary +=
            "\n" +
            comparisons[k].text(references[k] ? "../" + references[k]->folder.filename().string() : std::string());
        if (references[k] != nullptr)
        {
            lastEnd = std::max(lastEnd, fs::last_write_time(references[k]->folder / "cost"));
        }
    }
    const bool isDone = textOf(run.folder / comparisonsDict) == dictionary &&
                        fs::exists(run.folder / comparisonsFile) &&
                        fs::last_write_time(run.folder / comparisonsFile) >= lastEnd;
    if (!isDone)
    {
        fs::remove(run.folder / comparisonsFile);
        writeFile(run.folder / comparisonsDict, dictionary);
        run.outcome.failure = runCompareSamples(run, programs);
    }
    if (run.outcome.finished())
    {
        readCompared(run, comparisons, references);
    }
}

} // namespace slosh
