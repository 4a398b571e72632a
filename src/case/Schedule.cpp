// SPDX-License-Identifier: GPL-3.0-or-later
#include "case/Schedule.hpp"

#include "dictionary/Dictionary.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <string_view>

namespace slosh
{

namespace
{

/// Multiples of the interval up to `x`; one that is missed by a rounding counts.
double multiples(double x, double interval)
{
    return std::floor(x / interval + 1e-9);
}

namespace schedule
{

using Control = Schedule::Control;

/// What the interval is.
enum class By
{
    nothing,
    count,
    seconds
};

/// What writeControl can be.
struct Way
{
    std::string_view name, sentence;
    Control control;
    By by;
};

constexpr std::array<Way, 11> ways = {
    {{"timeStep", "every writeInterval steps", Control::timeStep, By::count},
     {"runTime", "at the end of the first step that reaches a multiple of writeInterval", Control::runTime,
      By::seconds},
     {"adjustableRunTime", "steps are adjusted to end on multiples of writeInterval", Control::adjustableRunTime,
      By::seconds},
     {"adjustable", "same as adjustableRunTime", Control::adjustableRunTime, By::seconds},
     {"clockTime", "at the end of the first step that reaches a multiple of writeInterval in wall-clock time",
      Control::clockTime, By::seconds},
     {"cpuTime", "as clockTime, but in CPU time", Control::cpuTime, By::seconds},
     {"none", "never", Control::never, By::nothing},
     {"always", "every step", Control::timeStep, By::nothing},
     {"writeTime", "every writeInterval written times", Control::writeTime, By::count},
     {"outputTime", "same as writeTime", Control::writeTime, By::count},
     {"onEnd", "after the last step", Control::onEnd, By::nothing}}};
constexpr std::size_t ofRuns = 7; ///< the others are for functions alone

/// The first `n`, each with the entry of its interval.
template <const Key& number, const Key& seconds>
Options firstWays(std::size_t n)
{
    Options options;
    for (std::size_t k = 0; k < n; ++k)
    {
        const By by = ways[k].by;
        options.push_back(
            {ways[k].name, ways[k].sentence,
             by == By::count     ? [] { return Keys{number}; }
             : by == By::seconds ? [] { return Keys{seconds}; }
                                 : [] { return withoutEffect({number.name}); }}
        );
    }
    return options;
}

Schedule readBy(const Dictionary& dict, const Key& control, const Key& number, const Key& seconds)
{
    const std::string word = dict.choice(control, std::string(control.name));
    const Way& way = *std::find_if(ways.begin(), ways.end(), [&](const Way& one) { return one.name == word; });
    return {
        way.control, way.by == By::count     ? static_cast<double>(dict.label(number))
                     : way.by == By::seconds ? dict.scalar(seconds)
                                             : 1};
}

constexpr Key writeNumber{.name = "writeInterval", .otherwise = "1", .range = atLeast(1), .sentence = "steps"};
constexpr Key writeSeconds{
    .name = "writeInterval",
    .example = "0.5",
    .unit = unit::second,
    .range = positive,
    .sentence = "of simulated, wall-clock or CPU time"};
constexpr Key writeControl{
    .name = "writeControl",
    .otherwise = "timeStep",
    .example = "adjustableRunTime",
    .sentence = "when times are written",
    .options = [] { return firstWays<writeNumber, writeSeconds>(ofRuns); }};

constexpr Key sampleNumber{
    .name = "writeInterval", .otherwise = "1", .range = atLeast(1), .sentence = "number of steps or written times"};
constexpr Key sampleSeconds{
    .name = "writeInterval",
    .example = "0.01",
    .unit = unit::second,
    .range = positive,
    .sentence = "of simulated, wall-clock or CPU time"};
constexpr Key sampleControl{
    .name = "writeControl",
    .otherwise = "timeStep",
    .example = "runTime",
    .sentence = "when the function samples, independent of writeControl in controlDict",
    .options = [] { return firstWays<sampleNumber, sampleSeconds>(ways.size()); }};

constexpr Key executeNumber{
    .name = "executeInterval", .otherwise = "1", .range = atLeast(1), .sentence = "as writeInterval"};
constexpr Key executeSeconds{
    .name = "executeInterval",
    .example = "0.01",
    .unit = unit::second,
    .range = positive,
    .sentence = "as writeInterval"};
constexpr Key executeControl{
    .name = "executeControl",
    .otherwise = "timeStep",
    .example = "runTime",
    .sentence = "instead of writeControl",
    .options =
        []
    {
        Options options = firstWays<executeNumber, executeSeconds>(ways.size());
        for (Option& option : options)
        {
            option.sentence = {}; // writeControl's
        }
        return options;
    },
    .alternative = true};

} // namespace schedule

} // namespace

Keys scheduleKeys()
{
    return {schedule::writeControl};
}

Keys functionScheduleKeys()
{
    return {schedule::sampleControl, schedule::executeControl};
}

Schedule Schedule::read(const Dictionary& controlDict)
{
    using namespace schedule;
    return readBy(controlDict, writeControl, writeNumber, writeSeconds);
}

Schedule Schedule::readOfFunction(const Dictionary& function)
{
    using namespace schedule;
    const bool executes = function.has(executeControl) || function.has(executeNumber);
    const bool writes = function.has(sampleControl) || function.has(sampleNumber);
    if (executes && writes && !function.has(sampleControl))
    {
        throw function.errorAt(
            sampleNumber, "is set with executeControl or executeInterval; expected writeControl as well"
        );
    }
    return executes && !writes ? readBy(function, executeControl, executeNumber, executeSeconds)
                               : readBy(function, sampleControl, sampleNumber, sampleSeconds);
}

bool Schedule::isDue(const Instant& before, const Instant& now) const
{
    const auto passed = [this](double from, double to)
    { return multiples(to, interval_) > multiples(from, interval_); };
    const auto counts = [this](long n) { return n % static_cast<long>(interval_) == 0; };
    switch (control_)
    {
    case Control::timeStep:
        return counts(now.index);
    case Control::runTime:
    case Control::adjustableRunTime:
        return passed(before.time, now.time);
    case Control::clockTime:
        return passed(before.clock, now.clock);
    case Control::cpuTime:
        return passed(before.processor, now.processor);
    case Control::writeTime:
        return now.writes > before.writes && counts(now.writes);
    case Control::onEnd:
        return now.ends;
    case Control::never:
        break;
    }
    return false;
}

double Schedule::nextInstant(double now) const
{
    return control_ == Control::adjustableRunTime ? (multiples(now, interval_) + 1) * interval_
                                                  : std::numeric_limits<double>::infinity();
}

} // namespace slosh
