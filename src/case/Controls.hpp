// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "case/Case.hpp"
#include "case/Schedule.hpp"
#include "case/TimeStepControl.hpp"

#include <chrono>
#include <filesystem>
#include <functional>
#include <limits>
#include <map>
#include <string>
#include <vector>

namespace slosh
{

enum class WriteFormat
{
    ascii,
    binary
};

/// How values stand in files: writeFormat, writePrecision (digits of ascii values).
struct WriteOptions
{
    WriteFormat format = WriteFormat::ascii;
    int precision = 6;
};

/// The clock of a run, read from system/controlDict with OpenFOAM's keys. Signals are heeded as stopAt is
/// (case/signals.hpp).
class Controls
{
public:
    /// Throws CaseError for missing or bad entries, a start time that has no directory, endTime before it.
    explicit Controls(const Case& theCase);

    const Dictionary& dictionary() const { return dict_; }
    /// With runTimeModifiable: reads the entries anew (not functions) where controlDict or a file it includes has
    /// changed since it was last read, and returns a message; where there is an error the old entries stay valid, and
    /// the message describes it. "" where nothing has changed. `check` throws CaseError where it refuses the new
    /// entries. Asks the file system five times a second at most.
    std::string readIfModified(const std::function<void(const Controls&)>& check);

    double startTime() const { return startTime_; }             ///< as chosen by startFrom among the case's times
    const std::string& startName() const { return startName_; } ///< its directory
    double endTime() const { return endTime_; }

    bool adjustTimeStep() const { return step_.adjust; }
    /// adjustTimeStep: c0-based Courant number.
    double maxCo() const { return step_.maxCoUpTo(mostByDefault_); }
    /// Where the case does not say maxCo itself, it is at most this.
    void limitDefaultMaxCo(double most) { mostByDefault_ = most; }
    bool maxCoIsLimited() const { return maxCo() < step_.maxCo; }
    double maxDeltaT() const { return step_.maxDeltaT; } ///< [s], default infinite
    double fixedDeltaT() const { return step_.deltaT; }  ///< [s], deltaT of the dictionary

    /// Continues a run: exact time, step number and last step of a restarted case (uniform/time).
    void resume(double time, long index, double deltaT);

    const Instant& now() const { return now_; }
    const Instant& before() const { return before_; } ///< the last step
    double time() const { return now_.time; }
    double previousTime() const { return before_.time; }
    long index() const { return now_.index; } ///< steps since the case began
    double deltaT() const { return currentDeltaT_; }

    /// False once endTime is reached (to half a rounding of deltaT) or stopAt or a signal has ended the run.
    bool running() const;
    /// Why a run is over before endTime: "stopAt writeNow", "SIGTERM"; nothing where it is not.
    std::string stoppedBy() const;

    /// The step to take: the wanted one, shortened so that it ends on endTime, on a write instant or on `instant`,
    /// whichever comes first. Shortening spreads over the last two steps so that no sliver is left.
    double limitDeltaT(double wanted, double instant) const;
    /// Advances the clock by dt, onto the instant itself where it ends within a rounding of one.
    void advance(double dt);

    /// Undoes the last advance(): for a step that failed.
    void stepBack();

    bool isWriteTime() const { return now_.writes > before_.writes; }
    std::string timeName() const { return timeName(now_.time); }
    std::string timeName(double time
    ) const; ///< timeFormat and timePrecision; raised where a step would share its name with the next
    const WriteOptions& writeOptions() const { return writeOptions_; }

    /// purgeWrite: notes a directory this run wrote and removes the oldest of them beyond the number kept. Never the
    /// start directory.
    void purge(const Case& theCase, const std::string& written);

private:
    void read();
    void noteFiles();

    std::filesystem::path root_;
    Dictionary dict_;
    std::map<std::filesystem::path, std::filesystem::file_time_type> files_; ///< of dict_, and when they were changed
    bool modifiable_ = false;
    double lookedAt_ = 0; ///< the files, by the clock
    std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
    double startTime_ = 0;
    std::string startName_;
    double endTime_ = 0;
    TimeStepControl step_;
    double mostByDefault_ = std::numeric_limits<double>::infinity();
    Instant now_, before_;
    double currentDeltaT_ = 0;
    double previousDeltaT_ = 0;
    Schedule write_;
    WriteOptions writeOptions_;
    int timePrecision_ = 6;
    char timeFormat_ = 'g';
    int purgeWrite_ = 0;
    enum class StopAt
    {
        endTime,
        writeNow,
        noWriteNow,
        nextWrite
    };
    StopAt stopAt_ = StopAt::endTime;
    bool stopped_ = false; ///< by stopAt or a signal, at the end of the last step
    std::vector<std::string> written_;
};

/// All entries of system/controlDict, and those of them that others read, too.
Keys controlDictKeys();
Key endTimeKey();
Key writePrecisionKey();
Key functionsKey();

} // namespace slosh
