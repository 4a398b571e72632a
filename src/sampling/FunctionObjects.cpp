// SPDX-License-Identifier: GPL-3.0-or-later
#include "sampling/FunctionObjects.hpp"

#include <algorithm>
#include <map>
#include <sstream>

namespace slosh
{

namespace
{

using Make = std::unique_ptr<FunctionObject> (*)(const FunctionSetting&);

const std::map<std::string, Make>& types()
{
    static const std::map<std::string, Make> table = {{"probes", makeProbes},
                                                      {"interfaceHeight", makeInterfaceHeight},
                                                      {"forces", makeForces},
                                                      {"energies", makeEnergies},
                                                      {"centreOfMass", makeCentreOfMass},
                                                      {"densityDeviation", makeDensityDeviation},
                                                      {"extent", makeExtent},
                                                      {"semiAxes", makeSemiAxes},
                                                      {"particlesOutside", makeParticlesOutside}};
    return table;
}

} // namespace

std::vector<Vec> pointsInTank(const FunctionSetting& setting, const std::string& key)
{
    const std::vector<Vec> points = setting.dict.vectors(key, unit::metre);
    const Tank& tank = setting.scene.tank;
    if (points.empty())
    {
        throw setting.dict.errorAt(key, "holds no point");
    }
    for (const Vec& X : points)
    {
        Vec inSlice = X;
        if (const int d = tank.emptyDirection(); d >= 0)
        {
            inSlice[d] = std::clamp(X[d], tank.box().min()[d], tank.box().max()[d]);
        }
        // On a wall, to rounding, is inside.
        if (tank.distanceToWall(X) < -1e-9 * tank.box().sizes().maxCoeff() || inSlice != X)
        {
            const Vec low = tank.box().min(), high = tank.box().max();
            std::ostringstream message;
            message << "holds (" << X.transpose() << "), which is outside the tank, "
                    << (tank.isBox() ? "(" : "a " + tank.walls().name() + " within (") << low.transpose() << ") to ("
                    << high.transpose() << "), or in a body,";
            throw setting.dict.errorAt(key, message.str());
        }
    }
    return points;
}

FunctionObjects FunctionObjects::read(const Dictionary& controlDict, const std::filesystem::path& folder,
                                      const Scene& scene, const std::string& startName)
{
    FunctionObjects all;
    const Dictionary functions = controlDict.dictOr("functions");
    std::vector<std::string> valid;
    for (const auto& type : types())
    {
        valid.push_back(type.first);
    }
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
        const std::string type = dict.choice("type", valid, "function type");
        function.object =
            types().at(type)({dict, scene, folder / name / startName,
                              static_cast<int>(controlDict.labelOr("writePrecision", 6, between(1, 17)))});
        dict.refuseUnknown();
        all.functions_.push_back(std::move(function));
    }
    return all;
}

bool FunctionObjects::isDue(const Moment& before, const Moment& now) const
{
    return std::any_of(functions_.begin(), functions_.end(),
                       [&](const Function& function) { return function.isDue(before, now); });
}

void FunctionObjects::execute(const Snapshot& snapshot, const Moment& before, const Moment& now)
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
    return std::any_of(functions_.begin(), functions_.end(),
                       [](const Function& function) { return function.object->wantsBudget(); });
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
