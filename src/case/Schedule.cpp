// SPDX-License-Identifier: GPL-3.0-or-later
#include "case/Schedule.hpp"

#include "dictionary/Dictionary.hpp"

#include <cmath>
#include <limits>
#include <map>
#include <vector>

namespace slosh
{

namespace
{

using Control = Schedule::Control;

/// What writeControl of a run may be; a function knows more.
const std::map<std::string, Control> wordsOfRun = {
    {"timeStep", Control::timeStep},
    {"runTime", Control::runTime},
    {"adjustableRunTime", Control::adjustableRunTime},
    {"adjustable", Control::adjustableRunTime},
    {"clockTime", Control::clockTime},
    {"cpuTime", Control::cpuTime},
    {"none", Control::never}};

/// Multiples of the interval up to `x`; one that is missed by a rounding counts.
double multiples(double x, double interval)
{
    return std::floor(x / interval + 1e-9);
}

Schedule readAmong(const std::map<std::string, Control>& words, const Dictionary& dict, const std::string& prefix)
{
    const std::string controlKey = prefix + "Control", intervalKey = prefix + "Interval";
    std::vector<std::string> valid;
    valid.reserve(words.size());
    for (const auto& [word, control] : words)
    {
        valid.push_back(word);
    }
    const std::string word = dict.choiceOr(controlKey, "timeStep", valid, controlKey);
    switch (const Control control = words.at(word))
    {
    case Control::never:
    case Control::onEnd:
        dict.allow({intervalKey});
        return Schedule(control, 1);
    case Control::timeStep:
    case Control::writeTime:
        if (word == "always")
        {
            dict.allow({intervalKey});
            return Schedule(control, 1);
        }
        return Schedule(control, static_cast<double>(dict.labelOr(intervalKey, 1, atLeast(1))));
    default:
        return Schedule(control, dict.scalar(intervalKey, unit::second, positive));
    }
}

} // namespace

Schedule Schedule::read(const Dictionary& dict, const std::string& prefix)
{
    return readAmong(wordsOfRun, dict, prefix);
}

Schedule Schedule::readOfFunction(const Dictionary& dict, const std::string& prefix)
{
    std::map<std::string, Control> words = wordsOfRun;
    words.insert(
        {{"always", Control::timeStep},
         {"writeTime", Control::writeTime},
         {"outputTime", Control::writeTime},
         {"onEnd", Control::onEnd}}
    );
    return readAmong(words, dict, prefix);
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
