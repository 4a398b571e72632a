// SPDX-License-Identifier: GPL-3.0-or-later
#include "models.hpp"

#include "theirFiles.hpp"

namespace slosh
{

namespace
{

void warnOfTurbulence(const Case& from, std::vector<std::string>& warnings)
{
    // Of OpenFOAM before 8 and foam-extend, then of OpenFOAM 8 and later.
    for (const std::string file : {"constant/turbulenceProperties", "constant/momentumTransport"})
    {
        if (!hasFile(from, file))
        {
            continue;
        }
        const Dictionary dict = dictionaryIn(from, file);
        if (const std::string type = dict.wordOr("simulationType", "laminar"); type != "laminar")
        {
            warnings.push_back(
                dict.placeOf("simulationType") + ": simulationType is " + type + "; turbulence is not modelled"
            );
        }
    }
}

bool isOff(const Dictionary& source)
{
    return source.has("active") && !source.flag("active");
}

/// Sources of one file, each a dictionary with a type.
void warnOfSources(const Dictionary& dict, std::vector<std::string>& warnings)
{
    for (const auto& name : dict.keys())
    {
        if (!dict.isDict(name))
        {
            continue;
        }
        const Dictionary source = dict.dict(name);
        if (isOff(source))
        {
            continue;
        }
        const std::string type = source.wordOr("type", "no type");
        if (type.find("cceleration") != std::string::npos)
        {
            throw errorIn(
                dict.placeOf(name), "'" + name + "' (" + type +
                                        ") accelerates the liquid; expected the motion in constant/dynamicMeshDict, "
                                        "and `active no;` here"
            );
        }
        warnings.push_back(dict.placeOf(name) + ": '" + name + "' (" + type + ") is not used");
    }
}

} // namespace

void warnOfModels(const Case& from, std::vector<std::string>& warnings)
{
    warnOfTurbulence(from, warnings);
    for (const std::string folder : {"constant/", "system/"})
    {
        for (const std::string name : {"fvOptions", "fvModels", "fvConstraints"})
        {
            if (hasFile(from, folder + name))
            {
                warnOfSources(dictionaryIn(from, folder + name), warnings);
            }
        }
    }
    for (const std::string file :
         {"constant/porosityProperties", "constant/MRFProperties", "constant/MRFZones", "constant/SRFProperties"})
    {
        if (hasFile(from, file))
        {
            warnings.push_back(file + ": the file is not used");
        }
    }
}

} // namespace slosh
