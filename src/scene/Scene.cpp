// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/Scene.hpp"

#include "viscosities/readViscosity.hpp"

namespace slosh
{

namespace
{

namespace wall
{

constexpr Key type{.name = "type", .otherwise = "Adami", .options = [] {
                       return Options{{"Adami", "dummy particles with the fictitious force, Adami et al. 2012"}};
                   }};
constexpr Key suction{
    .name = "suction",
    .otherwise = "no",
    .sentence = "whether the pressure at walls may be negative; if not, liquid can separate from them, except where "
                "soundDamping finds that air cannot reach; scheme smallWaves: yes"};
constexpr Key dictionary{.name = "wall", .entries = [] { return Keys{type, suction}; }};

} // namespace wall

bool readWallSuction(const Dictionary& sphSchemes)
{
    sphSchemes.ignore(sphSchemes.keys()); // the rest is the solver's
    const Dictionary dict = sphSchemes.dictOr(wall::dictionary);
    dict.choice(wall::type, "wall type");
    const bool suction = dict.flag(wall::suction);
    dict.refuseUnknown(wall::dictionary.entries());
    return suction;
}

/// Whether the liquid starts at rest in the tank, or with a velocity that is given relative to it.
bool liquidRestsInTank(const Dictionary& blockParticlesDict)
{
    blockParticlesDict.ignore(blockParticlesDict.keys()); // the rest is blockParticles'
    return blockParticlesDict.choice(liquidAtRestKey(), "liquidAtRest") == "tankFrame" ||
           !blockParticlesDict.textAt("initialFields/U").empty();
}

} // namespace

Key wallKey()
{
    return wall::dictionary;
}

Key particleSpacingKey()
{
    return {
        .name = "particleSpacing",
        .example = "#eval{ 0.155/15 }",
        .unit = unit::metre,
        .range = positive,
        .sentence = "requested dx; adjusted to fit the tank's sides and the depth, and reported"};
}

Key liquidAtRestKey()
{
    return {
        .name = "liquidAtRest",
        .otherwise = "inertialFrame",
        .sentence = "frame in which the liquid is at rest at the start, if the tank has a velocity at time 0",
        .options = [] {
            return Options{{"inertialFrame"}, {"tankFrame"}};
        }};
}

Scene Scene::read(const Case& theCase, double particleSpacing)
{
    Tank tank = Tank::read(theCase.dictionary("constant/tankProperties"));
    const Kernel kernel =
        Kernel::read(theCase.dictionaryIfPresent("constant/kernelProperties"), tank.dim(), particleSpacing);
    const Dictionary fluidProperties = theCase.dictionary("constant/fluidProperties");
    const FluidProperties fluid = FluidProperties::read(fluidProperties);
    std::shared_ptr<const SolidBodyMotion> motion =
        SolidBodyMotion::read(theCase.dictionaryIfPresent("constant/dynamicMeshDict"), theCase.root().string());
    const Vec gravity = theCase.gravity();
    const double automatic = slosh::automaticSpeedOfSound(
        tank, gravity, *motion, liquidRestsInTank(theCase.dictionaryIfPresent("system/blockParticlesDict"))
    );
    const TaitEquation equationOfState = fluid.equationOfState(tank, gravity, automatic);
    const ViscosityChoice viscosity = readViscosity(fluidProperties.dict("viscosity"), equationOfState);
    const bool suction = readWallSuction(theCase.dictionaryIfPresent("system/sphSchemes"));
    return {std::move(tank), kernel,    std::move(motion), gravity, equationOfState,
            fluid,           viscosity, particleSpacing,   suction, automatic};
}

Scene Scene::withSpacing(double spacing) const
{
    Scene scene = *this;
    scene.particleSpacing = spacing;
    scene.kernel = kernel.withSpacing(spacing);
    return scene;
}

Scene Scene::atRest(const Vec& g) const
{
    Scene scene = *this;
    scene.motion = SolidBodyMotion::stationary();
    scene.gravity = g;
    scene.automaticSpeedOfSound = slosh::automaticSpeedOfSound(tank, g, *scene.motion);
    return scene;
}

} // namespace slosh
