// SPDX-License-Identifier: GPL-3.0-or-later
#include "motion/SolidBodyMotion.hpp"

#include "motion/MotionFunction.hpp"

#include <limits>

namespace slosh
{

namespace
{

class Stationary final : public SolidBodyMotion
{
public:
    RigidState at(double) const override { return {}; }
    std::string description() const override { return "stationary"; }
    bool isStationary() const override { return true; }
};

} // namespace

double SolidBodyMotion::lastTime() const
{
    return std::numeric_limits<double>::infinity();
}

std::unique_ptr<SolidBodyMotion> SolidBodyMotion::stationary()
{
    return std::make_unique<Stationary>();
}

std::string shown(const Vec& x)
{
    std::ostringstream text;
    text << "(" << x[0] << " " << x[1] << " " << x[2] << ")";
    return text.str();
}

double readOmega(const Dictionary& coeffs)
{
    const auto& tokens = coeffs.tokens("omega");
    if (tokens.size() == 2 && tokens[0].text == "constant" && tokens[1].kind == Token::Kind::number)
    {
        return tokens[1].number;
    }
    return coeffs.scalar("omega", unit::radianPerSecond);
}

std::unique_ptr<MotionFunction> readMotionFunction(const Dictionary& dict, const std::string& caseFolder)
{
    const std::string name =
        dict.choice("solidBodyMotionFunction",
                    {"linearMotion", "oscillatingLinearMotion", "rotatingMotion", "axisRotationMotion",
                     "oscillatingRotatingMotion", "tabulated6DoFMotion", "SDA", "multiMotion"},
                    "solidBodyMotionFunction");
    // As OpenFOAM: in <name>Coeffs, or beside the name.
    const bool apart = dict.has(name + "Coeffs");
    const Dictionary coeffs = apart ? dict.dict(name + "Coeffs") : dict;
    std::unique_ptr<MotionFunction> motion;
    if (name == "linearMotion")
    {
        motion = readLinearMotion(coeffs);
    }
    else if (name == "oscillatingLinearMotion")
    {
        motion = readOscillatingLinearMotion(coeffs);
    }
    else if (name == "rotatingMotion")
    {
        motion = readRotatingMotion(coeffs);
    }
    else if (name == "axisRotationMotion")
    {
        motion = readAxisRotationMotion(coeffs);
    }
    else if (name == "oscillatingRotatingMotion")
    {
        motion = readOscillatingRotatingMotion(coeffs);
    }
    else if (name == "SDA")
    {
        motion = readSDA(coeffs);
    }
    else if (name == "tabulated6DoFMotion")
    {
        motion = readTabulated6DoFMotion(coeffs, caseFolder);
    }
    else
    {
        motion = readMultiMotion(coeffs, caseFolder);
    }
    if (apart)
    {
        coeffs.refuseUnknown();
    }
    return motion;
}

RigidState SolidBodyMotion::over(double begin, double end) const
{
    if (begin == end || isStationary())
    {
        return at(begin);
    }
    const RigidState first = at(begin), last = at(end);
    RigidState mean = at((begin + end) / 2);
    mean.velocity = (first.velocity + last.velocity) / 2;
    mean.omega = (first.omega + last.omega) / 2;
    mean.acceleration = (last.velocity - first.velocity) / (end - begin);
    mean.omegaDot = (last.omega - first.omega) / (end - begin);
    return mean;
}

std::unique_ptr<SolidBodyMotion> SolidBodyMotion::read(const Dictionary& dict, const std::string& caseFolder)
{
    const std::vector<std::string> meshes = {"staticFvMesh", "dynamicMotionSolverFvMesh", "solidBodyMotionFvMesh"};
    if (dict.keys().empty())
    {
        return stationary();
    }
    // What belongs to OpenFOAM's mesh and says nothing about the motion.
    dict.allow(
        {"motionSolverLibs", "cellZone", "cellSet", "solidBodyMotionFvMeshCoeffs", "dynamicMotionSolverFvMeshCoeffs"});
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
            auto motion = readMotionFunction(inner, caseFolder);
            inner.refuseUnknown();
            return motion;
        }
    }
    auto motion = readMotionFunction(dict, caseFolder);
    if (dict.has(dict.word("solidBodyMotionFunction") + "Coeffs"))
    {
        dict.refuseUnknown();
    }
    return motion;
}

} // namespace slosh
