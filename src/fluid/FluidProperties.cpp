// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluid/FluidProperties.hpp"

#include <algorithm>
#include <cmath>

namespace slosh
{

FluidProperties FluidProperties::read(const Dictionary& dict)
{
    FluidProperties fluid;
    fluid.rho0 = dict.scalar("rho0", unit::density, positive);

    const Dictionary state = dict.dictOr("equationOfState");
    state.choiceOr("type", "Tait", {"Tait"}, "equation of state");
    fluid.gamma = state.scalarOr("gamma", fluid.gamma, unit::none, between(1, 10));
    if (state.has("speedOfSound") &&
        !(state.tokens("speedOfSound").size() == 1 && state.tokens("speedOfSound")[0].text == "auto"))
    {
        fluid.speedOfSound = state.scalar("speedOfSound", unit::velocity, positive);
    }
    state.refuseUnknown();

    const Dictionary viscosity = dict.dict("viscosity"); // the rest is viscosities/'s
    fluid.slip = viscosity.has("walls") && viscosity.choice("walls", {"noSlip", "slip"}, "wall condition") == "slip";

    const Dictionary friction = dict.dictOr("friction");
    friction.allow({"nu", "sideWalls"});
    if (friction.choiceOr("type", "none", {"none", "boundaryLayer"}, "friction type") == "boundaryLayer")
    {
        if (!fluid.slip)
        {
            throw friction.errorAt(
                "type", "is boundaryLayer, but the viscosity makes liquid stick to the walls, which "
                        "is friction of its own: give 'walls slip' in viscosity beside it,"
            );
        }
        fluid.friction.boundaryLayers = true;
        fluid.friction.nu = friction.scalar("nu", unit::kinematicViscosity, positive);
        const Dictionary sideWalls = friction.dictOr("sideWalls");
        sideWalls.allow({"omega"});
        fluid.friction.breadth = sideWalls.scalarOr("breadth", 0, unit::metre, positive);
        if (fluid.friction.breadth > 0 && sideWalls.has("omega") && sideWalls.tokens("omega")[0].text != "auto")
        {
            fluid.friction.omega = sideWalls.scalar("omega", unit::radianPerSecond, positive);
        }
        sideWalls.refuseUnknown();
    }
    friction.refuseUnknown();
    dict.refuseUnknown();
    return fluid;
}

double FluidProperties::sideWallDrag(const Tank& tank, const Vec& gravity) const
{
    if (friction.breadth == 0)
    {
        return 0;
    }
    if (tank.dim() == 3)
    {
        throw CaseError(
            "'sideWalls' of friction in constant/fluidProperties is for 2D tanks: in 3D side walls are walls",
            CaseError::Kind::input
        );
    }
    const auto omegas = friction.omega ? std::vector{*friction.omega} : tank.naturalFrequencies(gravity.norm(), 1);
    if (omegas.empty())
    {
        throw CaseError(
            "'omega' of friction's sideWalls in constant/fluidProperties is auto, but this tank has no "
            "natural frequency that is known: give the motion's, in rad/s",
            CaseError::Kind::input
        );
    }
    return 2 * std::sqrt(friction.nu * omegas.front() / 2) / friction.breadth;
}

TaitEquation FluidProperties::equationOfState(const Tank& tank, const Vec& gravity, const SolidBodyMotion& motion) const
{
    TaitEquation state{rho0, speedOfSound ? *speedOfSound : automaticSpeedOfSound(tank, gravity, motion), gamma};
    if (!(state.c0 > 0))
    {
        throw CaseError(
            "'speedOfSound auto' in constant/fluidProperties finds no speed to go by: no gravity and a tank at "
            "rest; give ten times the largest speed to be expected, in m/s",
            CaseError::Kind::input
        );
    }
    if (const double weight = rho0 * gravity.norm() * tank.fillDepth(); weight > 0)
    {
        const double g = gravity.norm();
        const bool isColumn = tank.isBox() || !tank.fill().fromWallToWall();
        state.rho0 *= isColumn
                          ? weight / state.hydrostatic(g, tank.fillDepth())
                          : rho0 / tank.meanOverDepth([&](double d) { return state.rho(state.hydrostatic(g, d)); });
    }
    return state;
}

double automaticSpeedOfSound(const Tank& tank, const Vec& gravity, const SolidBodyMotion& motion)
{
    BoundingBox box = tank.box();
    if (const int empty = tank.emptyDirection(); empty >= 0)
    {
        box.min()[empty] = box.max()[empty] = tank.box().center()[empty];
    }
    const double wallSpeed = motion.greatestSpeed(box, std::min(100.0, motion.lastTime()), 4000);
    return 10 * (std::sqrt(gravity.norm() * tank.fillDepth()) + wallSpeed);
}

} // namespace slosh
