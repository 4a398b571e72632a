// SPDX-License-Identifier: GPL-3.0-or-later
#include "case/Schedule.hpp"

#include "dictionary/Choice.hpp"

#include <cmath>
#include <limits>
#include <string>
#include <vector>

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
using Ways = std::vector<Choice<Schedule (*)(const Dictionary&)>>;

template <Control way>
Schedule withoutInterval(const Dictionary&)
{
    return {way, 1};
}

template <Control way, const Key& interval>
Schedule counted(const Dictionary& dict)
{
    return {way, static_cast<double>(dict.label(interval))};
}

template <Control way, const Key& interval>
Schedule timed(const Dictionary& dict)
{
    return {way, dict.scalar(interval)};
}

/// What writeControl of a run can be; `number` and `seconds` are the interval, by what the word counts.
template <const Key& number, const Key& seconds>
Ways waysOfRun()
{
    const auto counts = [] { return Keys{number}; };
    const auto times = [] { return Keys{seconds}; };
    return {
        {"timeStep", "every so many steps", counted<Control::timeStep, number>, counts},
        {"runTime", "at the end of the first step that reaches a multiple of the interval",
         timed<Control::runTime, seconds>, times},
        {"adjustableRunTime", "steps end on the multiples of the interval", timed<Control::adjustableRunTime, seconds>,
         times},
        {"adjustable", "another name of adjustableRunTime", timed<Control::adjustableRunTime, seconds>, times},
        {"clockTime", "at the first step that ends a multiple of the interval of real time later",
         timed<Control::clockTime, seconds>, times},
        {"cpuTime", "the same of the time of all processors", timed<Control::cpuTime, seconds>, times},
        {"none", "never", withoutInterval<Control::never>}};
}

/// A function knows more.
template <const Key& number, const Key& seconds>
Ways waysOfFunction()
{
    const auto counts = [] { return Keys{number}; };
    Ways ways = waysOfRun<number, seconds>();
    ways.insert(
        ways.end(), {{"always", "every step", withoutInterval<Control::timeStep>},
                     {"writeTime", "every so many times that are written", counted<Control::writeTime, number>, counts},
                     {"outputTime", "another name of writeTime", counted<Control::writeTime, number>, counts},
                     {"onEnd", "after the last step", withoutInterval<Control::onEnd>}}
    );
    return ways;
}

/// `ways` where another entry explains them.
Options onlyNamed(const Ways& ways)
{
    Options options = optionsOf(ways);
    for (Option& option : options)
    {
        option.sentence = {};
    }
    return options;
}

constexpr Key writeNumber{.name = "writeInterval", .otherwise = "1", .range = atLeast(1), .sentence = "steps"};
constexpr Key writeSeconds{
    .name = "writeInterval",
    .example = "0.5",
    .unit = unit::second,
    .range = positive,
    .sentence = "of simulated, real or processor time"};
constexpr Key writeControl{
    .name = "writeControl",
    .otherwise = "timeStep",
    .example = "adjustableRunTime",
    .sentence = "when times are written",
    .options = [] { return optionsOf(waysOfRun<writeNumber, writeSeconds>()); }};

constexpr Key sampleNumber{
    .name = "writeInterval", .otherwise = "1", .range = atLeast(1), .sentence = "steps, or times written"};
constexpr Key sampleSeconds{
    .name = "writeInterval",
    .example = "0.01",
    .unit = unit::second,
    .range = positive,
    .sentence = "of simulated, real or processor time"};
constexpr Key sampleControl{
    .name = "writeControl",
    .otherwise = "timeStep",
    .example = "runTime",
    .sentence = "when it samples, whatever controlDict says of times",
    .options = [] { return optionsOf(waysOfFunction<sampleNumber, sampleSeconds>()); }};

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
    .sentence = "in place of writeControl",
    .options = [] { return onlyNamed(waysOfFunction<executeNumber, executeSeconds>()); },
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
    static const Ways ways = waysOfRun<writeNumber, writeSeconds>();
    return choose(controlDict, writeControl, ways, std::string(writeControl.name)).read(controlDict);
}

Schedule Schedule::readOfFunction(const Dictionary& function)
{
    using namespace schedule;
    static const Ways writeWays = waysOfFunction<sampleNumber, sampleSeconds>(),
                      executeWays = waysOfFunction<executeNumber, executeSeconds>();
    const bool executes = function.has(executeControl) || function.has(executeNumber);
    const bool writes = function.has(sampleControl) || function.has(sampleNumber);
    if (executes && writes && !function.has(sampleControl))
    {
        throw function.errorAt(sampleNumber, "stands beside executeControl or executeInterval, without writeControl,");
    }
    const Key& key = writes ? sampleControl : executeControl;
    return choose(function, key, writes ? writeWays : executeWays, std::string(key.name)).read(function);
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
