// SPDX-License-Identifier: GPL-3.0-or-later
#include "CaseState.hpp"

#include "base/numberText.hpp"
#include "case/Case.hpp"
#include "case/foamFile.hpp"
#include "common/runProgram.hpp"
#include "dictionary/tokenize.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <fstream>
#include <iterator>
#include <map>
#include <sstream>

namespace slosh
{

namespace fs = std::filesystem;

namespace
{

std::string textOf(const fs::path& file)
{
    std::ifstream in(file, std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(in), {});
}

void readFigures(const SweptCase& one, const std::vector<Result>& results, CaseState& state)
{
    std::map<std::string, CaseState::Figure> found;
    std::istringstream lines(textOf(one.folder / comparisonsName));
    for (std::string line; std::getline(lines, line);)
    {
        std::istringstream words(line);
        std::string name, value, error, reference, uncertainty, referenceUncertainty;
        words >> name >> value >> error >> reference >> uncertainty >> referenceUncertainty;
        CaseState::Figure& figure = found[name];
        isNumber(value, figure.value); // nan is none
        isNumber(reference, figure.reference);
        isNumber(uncertainty, figure.uncertainty);
        isNumber(referenceUncertainty, figure.referenceUncertainty);
    }
    for (std::size_t k = 0; k < results.size(); ++k)
    {
        state.figures[k] = found[results[k].name];
    }
}

} // namespace

std::string CaseState::word() const
{
    switch (stage)
    {
    case Stage::waiting:
        return "waiting";
    case Stage::running:
        return "running";
    case Stage::stopped:
        return "stopped";
    case Stage::failed:
        return "failed";
    case Stage::finished:
        break;
    }
    return "finished";
}

std::string CaseState::reason() const
{
    return stage == Stage::failed    ? outcome.failure
           : stage == Stage::stopped ? "at " + numberText(time, 6) + " s"
           : !notCompared.empty()    ? "no results: " + notCompared
                                     : "";
}

CaseState readState(const SweptCase& one, const std::vector<Result>& results)
{
    CaseState state;
    state.figures.resize(results.size());
    if (!fs::is_directory(one.folder) || readDictionaryFiles(one.folder) != one.files)
    {
        return state;
    }
    const auto outcome = readOutcome(one.folder);
    const auto times = Case(one.folder).times();
    state.time = times.empty() ? 0 : times.back().value;
    if (!FolderLock(one.folder).isOurs())
    {
        state.stage = CaseState::Stage::running;
    }
    else if (!outcome)
    {
        state.stage = state.time > 0 ? CaseState::Stage::stopped : CaseState::Stage::waiting;
    }
    else
    {
        state.outcome = *outcome;
        state.stage = outcome->finished() ? CaseState::Stage::finished : CaseState::Stage::failed;
    }
    if (state.stage == CaseState::Stage::finished && !results.empty())
    {
        if (isCompared(one, results))
        {
            readFigures(one, results, state);
        }
        else
        {
            // Only an answer to this very question tells why there is none.
            const bool wasAsked = textOf(one.folder / comparisonsDictName) == comparisonsDict(one, results);
            state.notCompared = wasAsked ? failureOf(one.folder / "log.compareSamples", Ended{1, 0, 0, 0})
                                         : "the comparisons are missing; sloshSweep without -collect makes them";
        }
    }
    return state;
}

std::string comparisonsDict(const SweptCase& one, const std::vector<Result>& results)
{
    std::string text = foamHeader("dictionary", "system", "comparisonsDict");
    for (const Result& result : results)
    {
        text += "\n" + result.text(one.facts);
    }
    return text;
}

bool isCompared(const SweptCase& one, const std::vector<Result>& results)
{
    // A case that is made anew is cleared before, so that no older answer is left.
    return textOf(one.folder / comparisonsDictName) == comparisonsDict(one, results) &&
           fs::exists(one.folder / comparisonsName);
}

FolderLock::FolderLock(const fs::path& folder) : descriptor_(open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC))
{
    isOurs_ = descriptor_ < 0 || flock(descriptor_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK;
}

FolderLock::~FolderLock()
{
    if (descriptor_ >= 0)
    {
        close(descriptor_);
    }
}

} // namespace slosh
