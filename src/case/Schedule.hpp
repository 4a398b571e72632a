// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "dictionary/Key.hpp"

namespace slosh
{

class Dictionary;

/// Where a run stands at the end of a step.
struct Instant
{
    double time = 0;      ///< [s]
    long index = 0;       ///< steps since the case began
    double clock = 0;     ///< since the program started, [s]
    double processor = 0; ///< time of all processors since then, [s]
    long writes = 0;      ///< times written since then
    bool ends = false;    ///< the run
};

/// When something is done: OpenFOAM's writeControl with writeInterval. Multiples of time count from time 0, so that a
/// restarted run keeps the rhythm of the first.
class Schedule
{
public:
    enum class Control
    {
        never,
        timeStep,
        runTime,
        adjustableRunTime,
        clockTime,
        cpuTime,
        writeTime,
        onEnd
    };

    Schedule() = default;
    Schedule(Control control, double interval) : control_(control), interval_(interval) {}

    /// That of the run itself. Throws CaseError.
    static Schedule read(const Dictionary& controlDict);
    /// That of a function: writeControl and writeInterval, or, where it has neither, executeControl and
    /// executeInterval.
    static Schedule readOfFunction(const Dictionary& function);

    /// True where the step from `before` to `now` ends at or passes a multiple of the interval. A function of its
    /// arguments alone: nothing to be saved for a restart.
    bool isDue(const Instant& before, const Instant& now) const;
    /// The next instant a step from the time `now` must not pass, [s]: infinity unless adjustableRunTime.
    double nextInstant(double now) const;

private:
    Control control_ = Control::never;
    double interval_ = 1;
};

/// The entries of a schedule, of the run and of a function.
Keys scheduleKeys();
Keys functionScheduleKeys();

} // namespace slosh
