// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Sweep.hpp"

#include "study/Outcome.hpp"

namespace slosh
{

/// What has become of a case, as its folder tells it: there is no other record.
struct CaseState
{
    enum class Stage
    {
        waiting, ///< nothing of it, or something of other dictionaries
        running, ///< some program has it
        stopped, ///< can be continued from `time`
        failed,  ///< outcome.failure says why
        finished
    };

    struct Figure
    {
        double value = Outcome::unknown, uncertainty = Outcome::unknown;
        double reference = Outcome::unknown, referenceUncertainty = Outcome::unknown;
    };

    Stage stage = Stage::waiting;
    Outcome outcome;
    double time = 0;             ///< latest time written, [s]
    std::vector<Figure> figures; ///< by result
    std::string notCompared;     ///< why a finished case has no figures

    bool isComplete() const { return stage == Stage::finished && notCompared.empty(); }
    std::string word() const; ///< "finished"
    std::string reason() const;
};

CaseState readState(const SweptCase& one, const std::vector<Result>& results);

/// What compareSamples is asked for in the case.
std::string comparisonsDict(const SweptCase& one, const std::vector<Result>& results);
/// Whether it has answered just this.
bool isCompared(const SweptCase& one, const std::vector<Result>& results);

constexpr auto comparisonsDictName = "system/comparisonsDict";
constexpr auto comparisonsName = "postProcessing/compareSamples/comparisons.dat";

/// An exclusive lock on a folder, held until it is destroyed and until what was started with its descriptor has ended.
class FolderLock
{
public:
    explicit FolderLock(const std::filesystem::path& folder);
    ~FolderLock();
    FolderLock(const FolderLock&) = delete;
    FolderLock& operator=(const FolderLock&) = delete;

    /// False: somebody else has it. A file system without locks refuses nobody.
    bool isOurs() const { return isOurs_; }
    int descriptor() const { return descriptor_; }

private:
    int descriptor_ = -1;
    bool isOurs_ = true;
};

} // namespace slosh
