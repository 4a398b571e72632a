// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/Scene.hpp"

#include "viscosities/readViscosity.hpp"

namespace slosh
{

namespace
{

bool readWallSuction(const Dictionary& sphSchemes)
{
    sphSchemes.ignore(sphSchemes.keys()); // the rest is the solver's
    const Dictionary wall = sphSchemes.dictOr("wall");
    wall.choiceOr("type", "Adami", {"Adami"}, "wall type");
    const bool suction = wall.flagOr("suction", false);
    wall.refuseUnknown();
    return suction;
}

} // namespace

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
    const TaitEquation equationOfState = fluid.equationOfState(tank, gravity, *motion);
    const ViscosityChoice viscosity = readViscosity(fluidProperties.dict("viscosity"), equationOfState);
    const bool suction = readWallSuction(theCase.dictionaryIfPresent("system/sphSchemes"));
    return {std::move(tank), kernel,    std::move(motion), gravity, equationOfState,
            fluid,           viscosity, particleSpacing,   suction};
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
    return scene;
}

} // namespace slosh
