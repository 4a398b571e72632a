// SPDX-License-Identifier: GPL-3.0-or-later
#include "functions.hpp"

#include "ListReader.hpp"
#include "base/pointText.hpp"
#include "decimal.hpp"
#include "theirFiles.hpp"

#include <algorithm>
#include <regex>
#include <set>

namespace slosh
{

namespace
{

using Warnings = std::vector<std::string>;

struct TheirFunction
{
    std::string name, place;
    Dictionary dict;
};

void addThoseIn(const Dictionary& functions, std::vector<TheirFunction>& all)
{
    for (const auto& name : functions.keys())
    {
        if (functions.isDict(name)) // else a macro's value
        {
            all.push_back({name, functions.placeOf(name), functions.dict(name)});
        }
    }
}

/// functions { ... } of controlDict, functions ( ... ) of foam-extend, and system/functions of OpenFOAM 10 and after.
std::vector<TheirFunction> theirFunctions(const Case& from, const Dictionary& controlDict, Warnings& warnings)
{
    std::vector<TheirFunction> all;
    if (controlDict.isDict("functions"))
    {
        addThoseIn(controlDict.dict("functions"), all);
    }
    else if (controlDict.has("functions"))
    {
        try
        {
            ListReader list(controlDict, "functions");
            list.expect('(');
            while (!list.nextIs(')'))
            {
                const std::string place = list.place(), name = list.word();
                all.push_back({name, place, list.dictionary(name)});
            }
        }
        catch (const CaseError& error)
        {
            warnings.push_back(std::string(error.what()) + "; this function and those after it are omitted");
        }
    }
    if (hasFile(from, "system/functions"))
    {
        addThoseIn(dictionaryIn(from, "system/functions"), all);
    }
    return all;
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
        to.set("writeInterval", decimal(deltaT * from.scalarOr(interval, 1, unit::none, positive)));
    }
    else
    {
        to.set("writeControl", control);
        if (from.has(interval))
        {
            to.set("writeInterval", from.scalar(interval, unit::second, positive));
        }
    }
    if (from.has("enabled"))
    {
        to.set("enabled", from.flag("enabled") ? "yes" : "no");
    }
    for (const std::string key : {"timeStart", "timeEnd"})
    {
        if (from.has(key))
        {
            to.set(key, from.scalar(key, unit::second));
        }
    }
}

/// The points of an entry that are in the tank, as a list in our axes.
std::string pointsInside(const Dictionary& dict, const std::string& key, const FunctionSite& site, Warnings& warnings)
{
    std::string list;
    const ExtrudedTank& tank = site.tank;
    const BoundingBox box = tank.bounds();
    for (const Vec& theirs : dict.vectors(key, unit::metre))
    {
        const Vec X = site.turn(theirs);
        const bool inside =
            tank.contains(X) &&
            (!tank.flat || (X[tank.axis] >= box.min()[tank.axis] && X[tank.axis] <= box.max()[tank.axis]));
        if (inside)
        {
            list += " " + exactText(X);
        }
        else
        {
            warnings.push_back(
                dict.placeOf(key) + ": the point " + exactText(theirs) + " of " + key +
                " is outside the tank; it is omitted"
            );
        }
    }
    return list;
}

/// Whether an entry (walls "side.*") names a patch, itself or by its group, which is its type.
bool names(const std::vector<Token>& list, const std::string& patch, const std::string& type)
{
    return std::any_of(
        list.begin(), list.end(),
        [&](const Token& token)
        {
            const bool isPattern = token.kind == Token::Kind::string;
            return token.text == patch || token.text == type ||
                   (isPattern && std::regex_match(patch, std::regex(token.text)));
        }
    );
}

/// Forces on all walls; ours include the roof and open patches.
bool convertForces(const TheirFunction& theirs, const FunctionSite& site, Dictionary& to, Warnings& warnings)
{
    const std::vector<Token>& patches = theirs.dict.tokens("patches");
    std::set<std::string> missing, open;
    for (const OuterFace& face : outerFaces(site.mesh))
    {
        if (face.type != "empty" && !names(patches, face.patch, face.type))
        {
            (face.type == "wall" ? missing : open).insert(face.patch);
        }
    }
    const auto list = [](const std::set<std::string>& patches)
    {
        std::string text;
        for (const auto& patch : patches)
        {
            text += (text.empty() ? "'" : ", '") + patch + "'";
        }
        return text;
    };
    const std::string forces = theirs.place + ": the forces '" + theirs.name + "' ";
    if (!missing.empty())
    {
        warnings.push_back(
            forces + "do not include those on " + list(missing) +
            "; they are omitted, as all walls of the tank are one patch here"
        );
        return false;
    }
    if (!open.empty())
    {
        warnings.push_back(
            forces + "do not include those on " + list(open) + "; here they do, as the whole tank is a wall"
        );
    }
    if (site.moves)
    {
        warnings.push_back(forces + "have a fixed centre of moments; here it moves with the tank");
        to.set("axes", "inertial");
    }
    if (theirs.dict.has("CofR"))
    {
        to.set("CofR", site.turn(theirs.dict.vector("CofR", unit::metre)));
    }
    theirs.dict.ignore({"rho", "rhoInf", "p", "U"});
    return true;
}

/// Entries of theirs that make no difference here.
void ignoreHarmless(const Dictionary& dict)
{
    dict.ignore(
        {"libs", "functionObjectLibs", "log", "region", "writeFields", "executeControl", "executeInterval",
         "fixedLocations", "includeOutOfBounds", "interpolationScheme", "alpha", "liquid", "direction",
         "writePrecision", "writeFormat", "setFormat", "useUserTime"}
    );
}

void convertFunction(const TheirFunction& theirs, const FunctionSite& site, Dictionary& converted, Warnings& warnings)
{
    const std::string& name = theirs.name;
    const Dictionary& from = theirs.dict;
    const std::string type = from.wordOr("type", "no type");
    const auto omit = [&](const std::string& why)
    { warnings.push_back(theirs.place + ": the function '" + name + "' " + why + "; it is omitted"); };
    Dictionary to(name);
    to.set("type", type);
    if (type == "probes")
    {
        const std::vector<std::string> fields = from.words("fields");
        if (std::find(fields.begin(), fields.end(), "p") == fields.end())
        {
            omit("does not sample p");
            return;
        }
        for (const auto& field : fields)
        {
            if (field != "p")
            {
                warnings.push_back(
                    from.placeOf("fields") + ": the field " + field + " of '" + name + "' is omitted; probes sample p"
                );
            }
        }
        to.set("fields", "(p)");
    }
    if (type == "probes" || type == "interfaceHeight")
    {
        const std::string key = type == "probes" ? "probeLocations" : "locations";
        const std::string points = pointsInside(from, key, site, warnings);
        if (points.empty())
        {
            omit("has no point in the tank");
            return;
        }
        to.set(key, "(" + points + " )");
    }
    else if (type != "forces")
    {
        omit(from.has("type") ? "is of type " + type : "has no type");
        return;
    }
    else if (!convertForces(theirs, site, to, warnings))
    {
        return;
    }
    convertSchedule(from, site.deltaT, to);
    ignoreHarmless(from);
    for (const auto& entry : from.unusedEntries())
    {
        warnings.push_back(entry + " of '" + name + "' is not used");
    }
    converted.set(name, to);
}

} // namespace

Dictionary convertFunctions(
    const Case& from, const Dictionary& controlDict, const FunctionSite& site, std::vector<std::string>& warnings
)
{
    Dictionary converted("system/probesDict");
    for (const TheirFunction& theirs : theirFunctions(from, controlDict, warnings))
    {
        try
        {
            convertFunction(theirs, site, converted, warnings);
        }
        catch (const CaseError& error)
        {
            const std::string why = error.what();
            warnings.push_back(why.substr(0, why.find('\n')) + "; the function '" + theirs.name + "' is omitted");
        }
    }
    return converted;
}

} // namespace slosh
