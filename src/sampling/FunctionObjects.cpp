// SPDX-License-Identifier: GPL-3.0-or-later
#include "sampling/FunctionObjects.hpp"

#include <algorithm>

namespace slosh
{

FunctionObjects FunctionObjects::read(
    const Dictionary& controlDict, const std::filesystem::path& folder, const Scene& scene, const std::string& startName
)
{
    FunctionObjects all;
    const Dictionary functions = controlDict.dictOr("functions");
    for (const auto& name : functions.keys())
    {
        const Dictionary dict = functions.dict(name);
        if (!dict.flagOr("enabled", true))
        {
            continue;
        }
        dict.allow({"libs", "functionObjectLibs", "log", "region", "writeFields", "enabled"});
        Function function;
        function.name = name;
        function.schedule = Schedule::readOfFunction(dict, dict.has("writeControl") ? "write" : "execute");
        function.start = dict.scalarOr("timeStart", function.start, unit::second);
        function.end = dict.scalarOr("timeEnd", function.end, unit::second);
        dict.allow({"executeControl", "executeInterval"});
        const auto& type = choose(dict, "type", FunctionObject::choices(), "function type");
        function.object = type.read(
            {dict, scene, folder / name / startName,
             static_cast<int>(controlDict.labelOr("writePrecision", 6, between(1, 17)))}
        );
        dict.refuseUnknown();
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
