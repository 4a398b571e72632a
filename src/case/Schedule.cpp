#include "case/Schedule.hpp"

#include "dictionary/Dictionary.hpp"

#include <cmath>
#include <limits>

namespace slosh
{

namespace
{

/// Multiples of the interval up to `time`; one that is missed by a rounding counts.
double multiples(double time, double interval)
{
    return std::floor(time / interval + 1e-9);
}

} // namespace

Schedule Schedule::read(const Dictionary& dict, const std::string& prefix)
{
    const std::string key = prefix + "Control";
    const std::string word =
        dict.choiceOr(key, "timeStep", {"timeStep", "runTime", "adjustableRunTime", "adjustable", "none"}, key);
    if (word == "none")
    {
        dict.allow({prefix + "Interval"});
        return {};
    }
    if (word == "timeStep")
    {
        const long steps = dict.labelOr(prefix + "Interval", 1, atLeast(1));
        return Schedule(Control::timeStep, static_cast<double>(steps));
    }
    return Schedule(word == "runTime" ? Control::runTime : Control::adjustableRunTime,
                    dict.scalar(prefix + "Interval", unit::second, positive));
}

bool Schedule::isDue(double before, double now, long index) const
{
    switch (control_)
    {
    case Control::never:
        return false;
    case Control::timeStep:
        return index % static_cast<long>(interval_) == 0;
    default:
        return multiples(now, interval_) > multiples(before, interval_);
    }
}

double Schedule::nextInstant(double now) const
{
    return control_ == Control::adjustableRunTime ? (multiples(now, interval_) + 1) * interval_
                                                  : std::numeric_limits<double>::infinity();
}

} // namespace slosh
