// SPDX-License-Identifier: GPL-3.0-or-later
#include "Fluid.hpp"

#include "theirFiles.hpp"

#include "base/numberText.hpp"

#include <array>
#include <sstream>

namespace slosh
{

namespace
{

const std::string oldFile = "constant/transportProperties", newFile = "constant/phaseProperties";

/// Two phases, each with its name and its dictionary.
struct Phases
{
    Dictionary both; ///< where their names stand
    std::array<std::string, 2> names;
    std::vector<Dictionary> properties;
};

Phases namedIn(const Dictionary& both, const std::string& field)
{
    const std::vector<std::string> names = both.words("phases");
    if (names.size() != 2 || (field != "alpha1" && field != "alpha." + names[0]))
    {
        throw both.errorAt(
            "phases", "does not begin with the phase of " + field +
                          ", which system/setFieldsDict sets; expected two phases, the "
                          "liquid first"
        );
    }
    return {both, {names[0], names[1]}, {}};
}

Phases readPhases(const Case& from, const std::string& field)
{
    if (hasFile(from, newFile))
    {
        Phases phases = namedIn(dictionaryIn(from, newFile), field);
        for (const auto& name : phases.names)
        {
            phases.properties.push_back(dictionaryIn(from, "constant/physicalProperties." + name));
        }
        return phases;
    }
    if (!hasFile(from, oldFile))
    {
        throw errorIn(
            oldFile, "file not found; expected it, or " + newFile + " (OpenFOAM 10 and later), with the two phases"
        );
    }
    const Dictionary both = dictionaryIn(from, oldFile);
    if (!both.has("phases") && !(both.isDict("phase1") && both.isDict("phase2")))
    {
        throw errorIn(
            oldFile, "no phases found; expected `phases (water air);`, or phase1 { ... } and phase2 { ... } "
                     "(foam-extend, OpenFOAM before 2.3)"
        );
    }
    Phases phases = both.has("phases") ? namedIn(both, field) : Phases{both, {"phase1", "phase2"}, {}};
    if (field != "alpha1" && field != "alpha." + phases.names[0])
    {
        throw errorIn(
            both.placeOf("phase1"), "phase1 is the liquid (foam-extend, OpenFOAM before 2.3), but system/setFieldsDict "
                                    "sets " +
                                        field + "; expected alpha1 there"
        );
    }
    for (const auto& name : phases.names)
    {
        phases.properties.push_back(both.dict(name));
    }
    return phases;
}

/// Coefficients of viscosity models: no warning of those that are not used.
void ignoreModels(const Dictionary& dict)
{
    for (const auto& key : dict.keys())
    {
        if (key.ends_with("Coeffs"))
        {
            dict.ignore({key});
        }
    }
}

} // namespace

Fluid Fluid::read(const Case& from, const std::string& field, std::vector<std::string>& warnings)
{
    const Phases phases = readPhases(from, field);
    const Dictionary &liquid = phases.properties[0], &gas = phases.properties[1];
    const Fluid fluid{
        liquid.scalar("rho", unit::density, positive), liquid.scalar("nu", unit::kinematicViscosity, notNegative)};
    const double rhoGas = gas.scalar("rho", unit::density, positive);
    if (!(rhoGas < fluid.rho))
    {
        throw gas.errorAt(
            "rho", "is " + numberText(rhoGas) + ", not below that of '" + phases.names[0] +
                       "'; expected the density of a gas, whose motion is not computed"
        );
    }
    std::ostringstream ratio;
    ratio << rhoGas / fluid.rho;
    warnings.push_back(
        gas.placeOf("rho") + ": the gas '" + phases.names[1] + "', " + ratio.str() +
        " times as dense as the liquid, is not computed"
    );
    for (const std::string key : {"transportModel", "viscosityModel"})
    {
        const std::string model = liquid.wordOr(key, "Newtonian");
        if (model != "Newtonian" && model != "constant")
        {
            warnings.push_back(liquid.placeOf(key) + ": " + key + " is " + model + "; nu is constant instead");
        }
    }
    gas.ignore({"transportModel", "viscosityModel", "nu"});
    if (const Dictionary& both = phases.both; both.has("sigma"))
    {
        // A number, or a model of its own.
        if (both.isDict("sigma") || both.scalar("sigma", {{1, 0, -2}, "N/m"}) != 0)
        {
            warnings.push_back(both.placeOf("sigma") + ": sigma is not 0; surface tension is not computed");
        }
        both.ignore({"sigma"});
    }
    // Dictionaries of phases stand in transportProperties, or are files.
    ignoreModels(phases.both);
    ignoreModels(liquid);
    ignoreModels(gas);
    std::vector<Dictionary> files = {phases.both};
    if (hasFile(from, newFile))
    {
        files = {phases.both, liquid, gas};
    }
    for (const Dictionary& file : files)
    {
        for (const auto& entry : file.unusedEntries())
        {
            warnings.push_back(entry + " is not used");
        }
    }
    return fluid;
}

} // namespace slosh
