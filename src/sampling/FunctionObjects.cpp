// SPDX-License-Identifier: GPL-3.0-or-later
#include "sampling/FunctionObjects.hpp"

#include "case/Controls.hpp"

#include <algorithm>

namespace slosh
{

namespace
{

namespace probesDict
{

constexpr Key type{.name = "type", .options = [] { return optionsOf(FunctionObject::choices()); }};
constexpr Key timeStart{
    .name = "timeStart",
    .leftOut = "start of the run",
    .example = "0",
    .unit = unit::second,
    .sentence = "no execution before this time",
    .alternative = true};
constexpr Key timeEnd{
    .name = "timeEnd",
    .leftOut = "end of the run",
    .example = "20",
    .unit = unit::second,
    .sentence = "no execution after this time",
    .alternative = true};
constexpr Key enabled{
    .name = "enabled",
    .otherwise = "yes",
    .sentence = "whether the function is read and executed",
    .alternative = true};

/// Of all functions.
Keys entries()
{
    const Keys own = {timeStart, timeEnd, enabled};
    const Keys ofFoam = withoutEffect({"libs", "functionObjectLibs", "log", "region", "writeFields"});
    return joined({type}, joined(functionScheduleKeys(), joined(own, ofFoam)));
}

constexpr Key function{.name = "pressure", .entries = entries, .anyName = true, .eachOption = true};

} // namespace probesDict

} // namespace

Keys probesDictKeys()
{
    return {probesDict::function};
}

FunctionObjects FunctionObjects::read(
    const Dictionary& controlDict, const std::filesystem::path& folder, const Scene& scene, const std::string& startName
)
{
    FunctionObjects all;
    const Dictionary functions = controlDict.dictOr(functionsKey());
    for (const auto& name : functions.keys())
    {
        const Dictionary dict = functions.dict(name);
        if (!dict.flag(probesDict::enabled))
        {
            continue;
        }
        Function function;
        function.name = name;
        function.schedule = Schedule::readOfFunction(dict);
        function.start = dict.scalarOr(probesDict::timeStart, function.start);
        function.end = dict.scalarOr(probesDict::timeEnd, function.end);
        const auto& type = choose(dict, probesDict::type, FunctionObject::choices(), "function type");
        function.object =
            type.read({dict, scene, folder / name / startName, static_cast<int>(controlDict.label(writePrecisionKey()))}
            );
        dict.refuseIdle(probesDict::entries());
        all.functions_.push_back(std::move(function));
    }
    return all;
}

bool FunctionObjects::isDue(const Instant& before, const Instant& now) const
{
    return std::any_of(
        functions_.begin(), functions_.end(), [&](const Function& function) { return function.isDue(before, now); }
    );
}

void FunctionObjects::execute(const Snapshot& snapshot, const Instant& before, const Instant& now)
{
    for (auto& function : functions_)
    {
        if (function.isDue(before, now))
        {
            function.object->execute(snapshot);
        }
    }
}

void FunctionObjects::executeAll(const Snapshot& snapshot)
{
    for (auto& function : functions_)
    {
        if (function.active(snapshot.state().time))
        {
            function.object->execute(snapshot);
        }
    }
}

double FunctionObjects::nextInstant(double now) const
{
    double next = std::numeric_limits<double>::infinity();
    for (const auto& function : functions_)
    {
        const double instant = function.schedule.nextInstant(now);
        if (function.active(instant))
        {
            next = std::min(next, instant);
        }
    }
    return next;
}

bool FunctionObjects::wantBudget() const
{
    return std::any_of(
        functions_.begin(), functions_.end(), [](const Function& function) { return function.object->wantsBudget(); }
    );
}

std::vector<std::string> FunctionObjects::names() const
{
    std::vector<std::string> names;
    for (const auto& function : functions_)
    {
        names.push_back(function.name);
    }
    return names;
}

std::vector<std::filesystem::path> FunctionObjects::files() const
{
    std::vector<std::filesystem::path> files;
    for (const auto& function : functions_)
    {
        const auto more = function.object->files();
        files.insert(files.end(), more.begin(), more.end());
    }
    return files;
}

} // namespace slosh
