// SPDX-License-Identifier: GPL-3.0-or-later
// A motion out of constant/dynamicMeshDict.
#include "motion/MotionFunction.hpp"

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
    .sentence = "older OpenFOAM's name of motionSolver",
    .options = motionSolvers,
    .alternative = true};

constexpr Key solidBodyMotionFunction{
    .name = "solidBodyMotionFunction",
    .example = "oscillatingRotatingMotion",
    .sentence = "its coefficients stand in <name>Coeffs, or beside it",
    .options = [] { return optionsOf(MotionFunction::choices()); }};

// Versions of OpenFOAM have the motion in one of these.
Keys besideMotion()
{
    return withoutEffect({"cellZone", "cellSet"});
}
constexpr Key solidBodyCoeffs{
    .name = "solidBodyCoeffs",
    .example = "solidBodyMotionFunction linearMotion; linearMotionCoeffs { velocity (0.1 0 0); }",
    .sentence = "solidBodyMotionFunction and its coefficients may stand in here, as versions of OpenFOAM have it",
    .entries = besideMotion,
    .alternative = true};
constexpr Key solidBodyMotionCoeffs{
    .name = "solidBodyMotionCoeffs", .sentence = "as solidBodyCoeffs", .entries = besideMotion, .alternative = true};
constexpr Key solidBodyMotionFvMeshCoeffs{
    .name = "solidBodyMotionFvMeshCoeffs",
    .sentence = "as solidBodyCoeffs",
    .entries = besideMotion,
    .alternative = true};

} // namespace dynamicMeshDict

const MotionFunction::Choice& chosenFunction(const Dictionary& dict)
{
    return choose(dict, dynamicMeshDict::solidBodyMotionFunction, MotionFunction::choices(), "solidBodyMotionFunction");
}

/// <name>Coeffs of the function that a dictionary names.
Key coeffsKey(const Dictionary& dict)
{
    return chosenFunction(dict).entries().front();
}

/// A function by name with its coefficients, from a dictionary that holds solidBodyMotionFunction.
std::unique_ptr<MotionFunction> readFunction(const Dictionary& dict, const std::string& caseFolder)
{
    const auto& function = chosenFunction(dict);
    // As OpenFOAM: in <name>Coeffs, or beside the name.
    const Key key = coeffsKey(dict);
    const bool apart = dict.has(key);
    const Dictionary coeffs = apart ? dict.dict(key) : dict;
    auto motion = function.read({coeffs, caseFolder, readFunction});
    if (apart)
    {
        coeffs.refuseUnknown(key.entries());
    }
    return motion;
}

} // namespace

Keys dynamicMeshDictKeys()
{
    using namespace dynamicMeshDict;
    // dynamicMotionSolverFvMeshCoeffs says nothing of the motion.
    return joined(
        {dynamicFvMesh, motionSolver, solver, solidBodyMotionFunction, solidBodyCoeffs, solidBodyMotionCoeffs,
         solidBodyMotionFvMeshCoeffs},
        withoutEffect({"motionSolverLibs", "cellZone", "cellSet", "dynamicMotionSolverFvMeshCoeffs"})
    );
}

std::unique_ptr<SolidBodyMotion> SolidBodyMotion::read(const Dictionary& dict, const std::string& caseFolder)
{
    using namespace dynamicMeshDict;
    if (dict.keys().empty())
    {
        return stationary();
    }
    if (dict.choice(dynamicFvMesh, "dynamicFvMesh type") == "staticFvMesh")
    {
        return stationary();
    }
    for (const Key& key : {motionSolver, solver})
    {
        dict.choice(key, "motion solver");
    }
    for (const Key& key : {solidBodyCoeffs, solidBodyMotionCoeffs, solidBodyMotionFvMeshCoeffs})
    {
        if (dict.isDict(key))
        {
            const Dictionary inner = dict.dict(key);
            auto motion = readFunction(inner, caseFolder);
            const Key coeffs = coeffsKey(inner);
            const Keys beside = inner.has(coeffs) ? Keys() : coeffs.entries();
            inner.refuseIdle(joined({solidBodyMotionFunction}, joined(beside, key.entries())));
            return motion;
        }
    }
    auto motion = readFunction(dict, caseFolder);
    if (dict.has(coeffsKey(dict)))
    {
        dict.refuseIdle(dynamicMeshDictKeys());
    }
    return motion;
}

} // namespace slosh
