// SPDX-License-Identifier: GPL-3.0-or-later
// A motion out of constant/dynamicMeshDict.
#include "motion/MotionFunction.hpp"

namespace slosh
{

namespace
{

/// A function by name with its coefficients, from a dictionary that holds solidBodyMotionFunction.
std::unique_ptr<MotionFunction> readFunction(const Dictionary& dict, const std::string& caseFolder)
{
    const auto& function =
        choose(dict, "solidBodyMotionFunction", MotionFunction::choices(), "solidBodyMotionFunction");
    // As OpenFOAM: in <name>Coeffs, or beside the name.
    const std::string key = std::string(function.name) + "Coeffs";
    const bool apart = dict.has(key);
    const Dictionary coeffs = apart ? dict.dict(key) : dict;
    auto motion = function.read({coeffs, caseFolder, readFunction});
    if (apart)
    {
        coeffs.refuseUnknown();
    }
    return motion;
}

} // namespace

std::unique_ptr<SolidBodyMotion> SolidBodyMotion::read(const Dictionary& dict, const std::string& caseFolder)
{
    const std::vector<std::string> meshes = {"staticFvMesh", "dynamicMotionSolverFvMesh", "solidBodyMotionFvMesh"};
    if (dict.keys().empty())
    {
        return stationary();
    }
    // What belongs to OpenFOAM's mesh and says nothing about the motion.
    dict.allow(
        {"motionSolverLibs", "cellZone", "cellSet", "solidBodyMotionFvMeshCoeffs", "dynamicMotionSolverFvMeshCoeffs"}
    );
    const std::string mesh = dict.choiceOr("dynamicFvMesh", "dynamicMotionSolverFvMesh", meshes, "dynamicFvMesh type");
    if (mesh == "staticFvMesh")
    {
        return stationary();
    }
    for (const auto* key : {"motionSolver", "solver"})
    {
        dict.choiceOr(key, "solidBody", {"solidBody"}, "motion solver");
    }
    for (const auto* key : {"solidBodyCoeffs", "solidBodyMotionCoeffs", "solidBodyMotionFvMeshCoeffs"})
    {
        if (dict.isDict(key))
        {
            const Dictionary inner = dict.dict(key);
            inner.allow({"cellZone", "cellSet"});
            auto motion = readFunction(inner, caseFolder);
            inner.refuseUnknown();
            return motion;
        }
    }
    auto motion = readFunction(dict, caseFolder);
    if (dict.has(dict.word("solidBodyMotionFunction") + "Coeffs"))
    {
        dict.refuseUnknown();
    }
    return motion;
}

} // namespace slosh
