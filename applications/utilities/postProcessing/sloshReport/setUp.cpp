// SPDX-License-Identifier: GPL-3.0-or-later
#include "setUp.hpp"

#include "fluid/FluidProperties.hpp"
#include "kernels/Kernel.hpp"
#include "particles/particleFiles.hpp"
#include "solver/Schemes.hpp"
#include "statistics/Spectrum.hpp"

#include <algorithm>
#include <array>
#include <sstream>

namespace slosh
{

namespace
{

std::string sizeOf(const Tank& tank)
{
    const Vec size = tank.box().sizes();
    std::string text = std::to_string(tank.dim()) + "D: ";
    if (tank.prism() != nullptr)
    {
        text += "a prism of " + std::to_string(tank.prism()->section().corners().size()) + " sides within ";
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

std::string viscosityOf(const FluidProperties& fluid)
{
    switch (fluid.viscosity)
    {
    case FluidProperties::Viscosity::none:
        return "none";
    case FluidProperties::Viscosity::artificial:
        return "artificial, alpha = " + number(fluid.alpha);
    case FluidProperties::Viscosity::laminar:
        return "laminar, nu = " + number(fluid.nu) + " m^2/s, walls " + (fluid.slip ? "slip" : "no slip");
    case FluidProperties::Viscosity::lowDissipationRiemann:
        break;
    }
    return "low-dissipation Riemann solver";
}

std::string schemesOf(const Schemes& schemes)
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
    text += schemes.wallSuction ? "; walls may pull"
            : damped            ? "; walls pull only where no air can reach them"
                                : "; walls do not pull";
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
    std::ostringstream out;
    out.precision(digits);
    out << value;
    return out.str();
}

SetUp SetUp::read(const Case& theCase)
{
    Tank tank = Tank::read(theCase.dictionary("constant/tankProperties"));
    const FluidProperties fluid = FluidProperties::read(theCase.dictionary("constant/fluidProperties"));
    SetUp set{std::move(tank),
              theCase.gravity(),
              SolidBodyMotion::read(theCase.dictionaryIfPresent("constant/dynamicMeshDict"), theCase.root().string()),
              {},
              {}};
    const auto add = [&](const std::string& name, const std::string& what) { set.facts.emplace_back(name, what); };
    add("Tank", sizeOf(set.tank));
    if (!set.tank.bodies().empty())
    {
        add("Bodies in it", namesOf(set.tank.bodies()));
    }
    add("Liquid", liquidOf(set.tank, fluid));
    add("Motion", set.motion->description());
    add("Gravity",
        "(" + number(set.gravity.x()) + " " + number(set.gravity.y()) + " " + number(set.gravity.z()) + ") m/s^2");

    double spacing = theCase.dictionary("system/blockParticlesDict").scalar("particleSpacing", unit::metre, positive);
    std::string particleText = number(spacing) + " m apart (as asked; blockParticles has not run)";
    if (const auto times = theCase.times(); !times.empty())
    {
        TimeState state;
        const Particles particles = readTime(theCase, times.back().name, state);
        spacing = particles.spacing;
        particleText = std::to_string(particles.nFluid) + " of liquid, " + std::to_string(particles.nWall) +
                       " of walls, " + number(spacing) + " m apart";
    }
    add("Particles", particleText + ": " + number(set.tank.fillDepth() / spacing) + " in the depth");
    const Kernel kernel =
        Kernel::read(theCase.dictionaryIfPresent("constant/kernelProperties"), set.tank.dim(), spacing);
    add("Kernel", kernel.name() + ", h = " + number(kernel.smoothingLength()) +
                      " m = " + number(kernel.smoothingLength() / spacing) + " spacings, support " +
                      number(kernel.supportRadius() / kernel.smoothingLength()) + " h");
    add("Equation of state", "Tait, gamma = " + number(fluid.gamma) + ", speed of sound " +
                                 number(fluid.equationOfState(set.tank, set.gravity, *set.motion).c0) + " m/s" +
                                 (fluid.speedOfSound ? "" : " (auto)"));
    add("Viscosity", viscosityOf(fluid));
    if (fluid.friction.boundaryLayers)
    {
        add("Friction",
            "boundary layers, nu = " + number(fluid.friction.nu) + " m^2/s" +
                (fluid.friction.breadth > 0 ? ", side walls " + number(fluid.friction.breadth) + " m apart" : ""));
    }
    add("Schemes", schemesOf(Schemes::read(theCase.dictionaryIfPresent("system/sphSchemes"))));

    if (set.tank.fill().fromWallToWall() && set.gravity.norm() > 0)
    {
        set.naturalFrequencies = set.tank.naturalFrequencies(set.gravity.norm(), 3);
    }
    return set;
}

double SetUp::motionFrequency(double begin, double end) const
{
    constexpr int samples = 4096;
    end = std::min(end, motion->lastTime());
    if (motion->isStationary() || !(end > begin))
    {
        return 0;
    }
    std::array<TimeSeries, 6> components;
    for (int k = 0; k < samples; ++k)
    {
        const double t = begin + (end - begin) * k / (samples - 1);
        const RigidState state = motion->at(t);
        for (int i = 0; i < 3; ++i)
        {
            const auto component = static_cast<std::size_t>(i);
            components[component].t.push_back(t);
            components[component].value.push_back(state.acceleration[i]);
            components[component + 3].t.push_back(t);
            components[component + 3].value.push_back(state.omegaDot[i]);
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
