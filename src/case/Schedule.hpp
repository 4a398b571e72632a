#pragma once

#include <string>

namespace slosh
{

class Dictionary;

/// When something is done: <prefix>Control timeStep | runTime | adjustableRunTime with <prefix>Interval in steps or
/// seconds. runTime: at the end of the first step that reaches a multiple of the interval; adjustableRunTime: the step
/// is shortened to end there. Multiples count from time 0, so that a restarted run keeps the rhythm of the first.
class Schedule
{
public:
    enum class Control
    {
        never,
        timeStep,
        runTime,
        adjustableRunTime
    };

    Schedule() = default;
    Schedule(Control control, double interval) : control_(control), interval_(interval) {}

    /// Reads <prefix>Control and <prefix>Interval; `prefix` "write", "execute" or "sample". Throws CaseError.
    static Schedule read(const Dictionary& dict, const std::string& prefix);

    /// True where the step from `before` to `now` (step number `index`) ends at or passes a multiple of the interval.
    /// A function of its arguments alone: nothing to be saved for a restart.
    bool isDue(double before, double now, long index) const;
    /// The next instant a step must not pass, [s]: infinity unless adjustableRunTime.
    double nextInstant(double now) const;

private:
    Control control_ = Control::never;
    double interval_ = 1;
};

} // namespace slosh
