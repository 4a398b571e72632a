// SPDX-License-Identifier: GPL-3.0-or-later
#include "setUp.hpp"

#include "base/numberText.hpp"
#include "fluid/FluidProperties.hpp"
#include "kernels/Kernel.hpp"
#include "particles/particleFiles.hpp"
#include "solver/Schemes.hpp"
#include "statistics/Spectrum.hpp"
#include "viscosities/readViscosity.hpp"

#include <algorithm>
#include <array>

namespace slosh
{

namespace
{

std::string sizeOf(const Tank& tank)
{
    const Vec size = tank.box().sizes();
    std::string text = std::to_string(tank.dim()) + "D: ";
    if (!tank.isBox())
    {
        text += tank.walls().description() + " within ";
    }
    for (const int direction : tank.directions())
    {
        text += number(size[direction]) + " m in " + "xyz"[direction] + (direction == 2 ? "" : " x ");
    }
    return text + (tank.dim() == 2 ? ", a slice " + number(tank.thickness()) + " m thick" : "");
}

std::string liquidOf(const Tank& tank, const FluidProperties& fluid)
{
    std::string text;
    if (tank.fill().fromWallToWall())
    {
        const double height = tank.box().sizes().z();
        text =
            number(tank.fillDepth()) + " m deep, " + number(100 * tank.fillDepth() / height, 3) + " % of the height; ";
    }
    else
    {
        text = "in regions, up to " + number(tank.fillDepth()) + " m above the bottom; ";
    }
    return text + number(tank.fill().volume()) + " m^3, " + number(fluid.rho0) + " kg/m^3, " +
           number(fluid.rho0 * tank.fill().volume()) + " kg";
}

std::string viscosityOf(const Scene& scene)
{
    const bool none = isNone(scene.viscosity);
    return describe(scene.viscosity) + (none ? "" : scene.fluid.slip ? ", slip walls" : ", no-slip walls");
}

std::string schemesOf(const Schemes& schemes, bool wallSuction)
{
    std::string text = "time integration " + schemes.timeIntegration + "; equations in the " +
                       (schemes.frame == Frame::tank ? "tank's" : "inertial") + " frame; density diffusion ";
    text += schemes.densityDiffusion == 0 ? "none" : "Fourtakas, delta = " + number(schemes.densityDiffusion);
    text += "; density re-initialised ";
    text += schemes.densityInterval == 0
                ? "never"
                : "by moving least squares every " + std::to_string(schemes.densityInterval) + " steps";
    const bool damped = schemes.soundDamping > 0;
    text += damped ? "; sound damped on a coarse grid" : "";
    text += wallSuction ? "; suction at walls"
            : damped    ? "; suction at walls only where air cannot reach"
                        : "; no suction at walls";
    return text + "; pair sums in " + (schemes.precision == Precision::single ? "single" : "double") + " precision";
}

std::string namesOf(const Shapes& bodies)
{
    std::string text;
    for (const auto& body : bodies)
    {
        text += (text.empty() ? "" : ", ") + body->name();
    }
    return text;
}

} // namespace

std::string number(double value, int digits)
{
    return numberText(value, digits);
}

SetUp SetUp::read(const Case& theCase)
{
    double spacing = theCase.dictionary("system/blockParticlesDict").scalar(particleSpacingKey());
    std::string particleText = number(spacing) + " m apart (requested; blockParticles has not run)";
    if (const auto times = theCase.times(); !times.empty())
    {
        TimeState state;
        const Particles particles = readTime(theCase, times.back().name, state);
        spacing = particles.spacing;
        particleText = std::to_string(particles.nFluid) + " of liquid, " + std::to_string(particles.nWall) +
                       " of walls, " + number(spacing) + " m apart";
    }
    SetUp set{Scene::read(theCase, spacing), {}, {}};
    const Scene& scene = set.scene;
    const Tank& tank = scene.tank;
    const FluidProperties& fluid = scene.fluid;
    const Vec& gravity = scene.gravity;
    const auto add = [&](const std::string& name, const std::string& what) { set.facts.emplace_back(name, what); };
    add("Tank", sizeOf(tank));
    if (!tank.bodies().empty())
    {
        add("Bodies", namesOf(tank.bodies()));
    }
    add("Liquid", liquidOf(tank, fluid));
    add("Motion", scene.motion->description());
    add("Gravity", "(" + number(gravity.x()) + " " + number(gravity.y()) + " " + number(gravity.z()) + ") m/s^2");

    add("Particles", particleText + ": " + number(tank.fillDepth() / spacing) + " over the depth");
    const Kernel& kernel = scene.kernel;
    add("Kernel", kernel.name() + ", h = " + number(kernel.smoothingLength()) +
                      " m = " + number(kernel.smoothingLength() / spacing) + " spacings, support " +
                      number(kernel.supportRadius() / kernel.smoothingLength()) + " h");
    add("Equation of state", "Tait, gamma = " + number(fluid.gamma) + ", speed of sound " +
                                 number(scene.equationOfState.c0) + " m/s" + (fluid.speedOfSound ? "" : " (auto)"));
    add("Viscosity", viscosityOf(scene));
    if (fluid.friction.boundaryLayers)
    {
        add("Friction",
            "boundary layers, nu = " + number(fluid.friction.nu) + " m^2/s" +
                (fluid.friction.breadth > 0 ? ", side walls " + number(fluid.friction.breadth) + " m apart" : ""));
    }
    add("Schemes", schemesOf(Schemes::read(theCase.dictionaryIfPresent("system/sphSchemes")), scene.wallSuction));

    if (tank.fill().fromWallToWall() && gravity.norm() > 0)
    {
        set.naturalFrequencies = tank.naturalFrequencies(gravity.norm(), 3);
    }
    return set;
}

double SetUp::motionFrequency(double begin, double end) const
{
    constexpr int samples = 4096;
    end = std::min(end, scene.motion->lastTime());
    if (scene.motion->isStationary() || !(end > begin))
    {
        return 0;
    }
    std::array<TimeSeries, 6> components;
    for (int k = 0; k < samples; ++k)
    {
        const double t = begin + (end - begin) * k / (samples - 1);
        const RigidState state = scene.motion->at(t);
        for (int i = 0; i < 3; ++i)
        {
            components[i].t.push_back(t);
            components[i].value.push_back(state.acceleration[i]);
            components[i + 3].t.push_back(t);
            components[i + 3].value.push_back(state.omegaDot[i]);
        }
    }
    double strongest = 0, highest = 1e-12; // below it is rounding
    for (const TimeSeries& component : components)
    {
        const Spectrum spectrum(component);
        const double peak = *std::max_element(spectrum.density.begin(), spectrum.density.end());
        if (peak > highest)
        {
            highest = peak;
            strongest = spectrum.strongest() >= 3 * spectrum.step ? spectrum.strongest() : 0;
        }
    }
    return strongest;
}

} // namespace slosh
