// SPDX-License-Identifier: GPL-3.0-or-later
// A motion out of constant/dynamicMeshDict.
#include "motion/MotionFunction.hpp"

#include <optional>

namespace slosh
{

namespace
{

namespace dynamicMeshDict
{

constexpr Key dynamicFvMesh{
    .name = "dynamicFvMesh", .otherwise = "dynamicMotionSolverFvMesh", .options = [] {
        return Options{
            {"staticFvMesh", "the tank stands still"}, {"dynamicMotionSolverFvMesh"}, {"solidBodyMotionFvMesh"}};
    }};

Options motionSolvers()
{
    return {{"solidBody"}};
}
constexpr Key motionSolver{.name = "motionSolver", .otherwise = "solidBody", .options = motionSolvers};
constexpr Key solver{
    .name = "solver",
    .otherwise = "solidBody",
    .sentence = "name of motionSolver in older OpenFOAM",
    .options = motionSolvers,
    .alternative = true};

constexpr Key solidBodyMotionFunction{
    .name = "solidBodyMotionFunction",
    .example = "oscillatingRotatingMotion",
    .sentence = "its coefficients are in <name>Coeffs or beside it",
    .options = [] { return optionsOf(MotionFunction::choices()); }};

constexpr Key cellZone{
    .name = "cellZone", .otherwise = "none", .sentence = "none or all: the tank moves as a whole", .alternative = true};
constexpr Key cellSet{.name = "cellSet", .otherwise = "none", .sentence = "as cellZone", .alternative = true};

// Versions of OpenFOAM have the motion in one of these.
Keys besideMotion()
{
    return {cellZone, cellSet};
}
constexpr Key solidBodyCoeffs{
    .name = "solidBodyCoeffs",
    .example = "solidBodyMotionFunction linearMotion; linearMotionCoeffs { velocity (0.1 0 0); }",
    .sentence = "may contain solidBodyMotionFunction and its coefficients, as in some versions of OpenFOAM",
    .entries = besideMotion,
    .alternative = true};
constexpr Key solidBodyMotionCoeffs{
    .name = "solidBodyMotionCoeffs", .sentence = "as solidBodyCoeffs", .entries = besideMotion, .alternative = true};
constexpr Key solidBodyMotionFvMeshCoeffs{
    .name = "solidBodyMotionFvMeshCoeffs",
    .sentence = "as solidBodyCoeffs",
    .entries = besideMotion,
    .alternative = true};

constexpr Key moverType{.name = "type", .example = "motionSolver", .options = [] { return Options{{"motionSolver"}}; }};
Keys besideMover()
{
    return joined({moverType, motionSolver, cellZone, cellSet}, withoutEffect({"libs"}));
}
constexpr Key mover{
    .name = "mover",
    .example = "solidBodyMotionFunction linearMotion; velocity (0.1 0 0);",
    .sentence = "as solidBodyCoeffs, in OpenFOAM 10 and after",
    .entries = besideMover,
    .alternative = true};

} // namespace dynamicMeshDict

std::unique_ptr<MotionFunction> readPart(const Dictionary& dict, const std::string& caseFolder);

const MotionFunction::Choice& chosenFunction(const Dictionary& dict)
{
    return choose(dict, dynamicMeshDict::solidBodyMotionFunction, MotionFunction::choices(), "solidBodyMotionFunction");
}

/// Throws where a part of the mesh moves.
void refusePartOfMesh(const Dictionary& dict)
{
    using namespace dynamicMeshDict;
    for (const Key& key : {cellZone, cellSet})
    {
        if (const std::string cells = dict.word(key); cells != "none" && cells != "all")
        {
            throw dict.errorAt(
                key, "is " + cells +
                         ": OpenFOAM moves these cells alone, here the tank moves as a whole; expected no such "
                         "entry, or all"
            );
        }
    }
}

/// Coefficients of motions that may be chosen another time: <name>Coeffs.
std::vector<std::string> coefficientsIn(const Dictionary& dict)
{
    std::vector<std::string> names = dict.keys();
    std::erase_if(names, [](const std::string& name) { return !name.ends_with("Coeffs"); });
    return names;
}

void ignoreWithoutEffect(const Dictionary& dict, const Keys& keys)
{
    for (const Key& key : keys)
    {
        if (key.noEffect)
        {
            dict.ignore({std::string(key.name)});
        }
    }
}

/// A function by name with its coefficients, as OpenFOAM in <name>Coeffs or beside the name, from a dictionary that
/// holds solidBodyMotionFunction and may hold `more`.
std::unique_ptr<MotionFunction>
readFunctionBeside(const Keys& more, const Dictionary& dict, const std::string& caseFolder)
{
    const auto& function = chosenFunction(dict);
    const Key key = function.entries().front();
    const bool apart = dict.has(key);
    const Dictionary coeffs = apart ? dict.dict(key) : dict;
    auto motion = function.read({coeffs, caseFolder, readPart});
    if (apart)
    {
        coeffs.refuseUnknown(key.entries());
    }
    Keys known = joined(apart ? Keys() : key.entries(), more);
    known.push_back(dynamicMeshDict::solidBodyMotionFunction);
    const std::vector<std::string> others = coefficientsIn(dict);
    for (const std::string& name : others)
    {
        known.push_back({.name = name});
    }
    ignoreWithoutEffect(dict, more);
    dict.refuseIdle(known);
    return motion;
}

std::unique_ptr<MotionFunction> readPart(const Dictionary& dict, const std::string& caseFolder)
{
    return readFunctionBeside({}, dict, caseFolder);
}

/// The entry that holds the motion, where it does not stand in dynamicMeshDict itself.
std::optional<Key> holderIn(const Dictionary& dict)
{
    using namespace dynamicMeshDict;
    for (const Key& key : {mover, solidBodyCoeffs, solidBodyMotionCoeffs, solidBodyMotionFvMeshCoeffs})
    {
        if (dict.isDict(key))
        {
            return key;
        }
    }
    return std::nullopt;
}

} // namespace

Keys dynamicMeshDictKeys()
{
    using namespace dynamicMeshDict;
    // dynamicMotionSolverFvMeshCoeffs says nothing of the motion.
    return joined(
        {dynamicFvMesh, motionSolver, solver, solidBodyMotionFunction, cellZone, cellSet, mover, solidBodyCoeffs,
         solidBodyMotionCoeffs, solidBodyMotionFvMeshCoeffs},
        withoutEffect({"motionSolverLibs", "dynamicMotionSolverFvMeshCoeffs", "topoChanger", "distributor"})
    );
}

std::optional<Dictionary> motionDictionary(const Dictionary& dict)
{
    using namespace dynamicMeshDict;
    if (dict.keys().empty() || dict.choice(dynamicFvMesh, "dynamicFvMesh type") == "staticFvMesh")
    {
        return std::nullopt;
    }
    for (const Key& key : {motionSolver, solver})
    {
        dict.choice(key, "motion solver");
    }
    const std::optional<Key> holder = holderIn(dict);
    if (!holder)
    {
        return dict;
    }
    const Dictionary inner = dict.dict(*holder);
    if (holder->name == mover.name)
    {
        inner.choice(moverType, "mover type");
        inner.choice(motionSolver, "motion solver");
    }
    return inner;
}

std::unique_ptr<SolidBodyMotion> SolidBodyMotion::read(const Dictionary& dict, const std::string& caseFolder)
{
    const std::optional<Dictionary> motion = motionDictionary(dict);
    if (!motion)
    {
        return stationary();
    }
    refusePartOfMesh(*motion);
    ignoreWithoutEffect(dict, dynamicMeshDictKeys());
    const std::optional<Key> holder = holderIn(dict);
    return readFunctionBeside(holder ? holder->entries() : dynamicMeshDictKeys(), *motion, caseFolder);
}

} // namespace slosh
