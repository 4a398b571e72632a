// SPDX-License-Identifier: GPL-3.0-or-later
#include "functions.hpp"

#include "base/numberText.hpp"

#include <algorithm>

namespace slosh
{

namespace
{

std::string shown(const Vec& X)
{
    return "(" + numberText(X[0]) + " " + numberText(X[1]) + " " + numberText(X[2]) + ")";
}

void convertSchedule(const Dictionary& from, double deltaT, Dictionary& to)
{
    const std::string prefix = from.has("outputControl") ? "output" : "write";
    std::string control = from.wordOr(prefix + "Control", "timeStep");
    if (control == "outputTime")
    {
        control = "writeTime";
    }
    const std::string interval = prefix + "Interval";
    if (control == "timeStep")
    {
        to.set("writeControl", "runTime");
        to.set("writeInterval", deltaT * from.scalarOr(interval, 1, unit::none, positive));
        return;
    }
    to.set("writeControl", control);
    if (from.has(interval))
    {
        to.set("writeInterval", from.scalar(interval, unit::second, positive));
    }
}

/// The points of an entry that are in the tank, as a list.
std::string pointsInside(
    const Dictionary& dict, const std::string& key, const ExtrudedTank& tank, std::vector<std::string>& warnings
)
{
    std::string list;
    for (const Vec& X : dict.vectors(key, unit::metre))
    {
        const BoundingBox box = tank.bounds();
        const bool inside =
            tank.contains(X) &&
            (!tank.flat || (X[tank.axis] >= box.min()[tank.axis] && X[tank.axis] <= box.max()[tank.axis]));
        if (inside)
        {
            list += " " + shown(X);
        }
        else
        {
            warnings.push_back(
                "the point " + shown(X) + " of '" + key + "'" + dict.placeOf(key) + " is outside the tank and left out"
            );
        }
    }
    return list;
}

} // namespace

Dictionary convertFunctions(const Dictionary& controlDict, const ExtrudedTank& tank, std::vector<std::string>& warnings)
{
    Dictionary converted("system/probesDict");
    if (controlDict.has("functions") && !controlDict.isDict("functions"))
    {
        if (controlDict.tokens("functions").size() > 2)
        {
            warnings.push_back("'functions'" + controlDict.placeOf("functions") + " is a list and left out");
        }
        return converted;
    }
    const Dictionary functions = controlDict.dictOr("functions");
    const double deltaT = controlDict.scalar("deltaT", unit::second, positive);
    for (const auto& name : functions.keys())
    {
        if (!functions.isDict(name))
        {
            continue; // a macro's value
        }
        const Dictionary from = functions.dict(name);
        const std::string type = from.word("type");
        const std::string key = type == "probes" ? "probeLocations" : type == "interfaceHeight" ? "locations" : "";
        std::vector<std::string> fields;
        if (type == "probes")
        {
            fields = from.words("fields");
        }
        const bool hasPressure = std::find(fields.begin(), fields.end(), "p") != fields.end();
        if (key.empty() || (type == "probes" && !hasPressure))
        {
            warnings.push_back(
                "the function '" + name + "' (" + type + ")" + functions.placeOf(name) + " is left out" +
                (key.empty() ? "" : ": it does not sample p")
            );
            continue;
        }
        for (const auto& field : fields)
        {
            if (field != "p")
            {
                warnings.push_back(
                    "the field " + field + " of '" + name + "'" + from.placeOf("fields") +
                    " is left out: probes sample p"
                );
            }
        }
        const std::string points = pointsInside(from, key, tank, warnings);
        if (points.empty())
        {
            continue;
        }
        Dictionary to(name);
        to.set("type", type);
        if (type == "probes")
        {
            to.set("fields", "(p)");
        }
        to.set(key, "(" + points + " )");
        convertSchedule(from, deltaT, to);
        converted.set(name, to);
    }
    return converted;
}

} // namespace slosh
