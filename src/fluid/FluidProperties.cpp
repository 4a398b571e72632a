// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluid/FluidProperties.hpp"

#include <algorithm>
#include <cmath>

namespace slosh
{

namespace
{

namespace fluidProperties
{

constexpr Key rho0{
    .name = "rho0",
    .example = "[1 -3 0 0 0 0 0] 1000",
    .unit = unit::density,
    .range = positive,
    .sentence = "mean density of the liquid at rest; dimensions may be omitted"};

constexpr Key gamma{.name = "gamma", .otherwise = "7", .range = between(1, 10)};
constexpr Key speedOfSound{
    .name = "speedOfSound",
    .otherwise = "auto",
    .unit = unit::velocity,
    .range = positive,
    .sentence = "c0; auto: 10 (sqrt(g D) + the largest speed of the tank's walls relative to the liquid), about ten "
                "times the largest speed of the liquid"};
constexpr Key equation{
    .name = "type",
    .otherwise = "Tait",
    .options = []
    {
        return Options{
            {"Tait", "p = rhoS c0^2/gamma ((rho/rhoS)^gamma - 1), rhoS the density at the surface, such that the mean "
                     "is rho0"}};
    }};
constexpr Key equationOfState{.name = "equationOfState", .entries = [] { return Keys{equation, gamma, speedOfSound}; }};

constexpr Key walls{
    .name = "walls",
    .leftOut = "by scheme: cao2014 noSlip, else slip",
    .example = "slip",
    .options = []
    {
        return Options{
            {"slip", "acts only within the liquid"},
            {"noSlip", "also acts between liquid and walls: no slip, to first order in the spacing"}};
    }};

constexpr Key breadth{
    .name = "breadth",
    .example = "0.062",
    .unit = unit::metre,
    .range = positive,
    .sentence = "distance between the walls"};
constexpr Key omega{
    .name = "omega",
    .otherwise = "auto",
    .unit = unit::radianPerSecond,
    .range = positive,
    .sentence = "frequency of the damped motion; auto: the first natural frequency"};
constexpr Key sideWalls{
    .name = "sideWalls",
    .leftOut = "none",
    .sentence = "in 2D: the two walls at the sides of the slice",
    .entries = [] {
        return Keys{breadth, omega};
    }};
constexpr Key nu{
    .name = "nu",
    .example = "1e-6",
    .unit = unit::kinematicViscosity,
    .range = positive,
    .sentence = "kinematic viscosity of the liquid"};
constexpr Key frictionType{
    .name = "type",
    .otherwise = "none",
    .example = "boundaryLayer",
    .options = []
    {
        return Options{
            {"none"},
            {"boundaryLayer",
             "laminar, growing with the time since wetting; turbulent above a Reynolds number of 5e5; included in "
             "`forces`; independent of alpha, c0 and the spacing",
             [] {
                 return Keys{nu, sideWalls};
             }}};
    }};
constexpr Key friction{
    .name = "friction",
    .sentence = "friction at slip walls from the liquid's viscosity; an error with walls noSlip",
    .entries = [] { return Keys{frictionType}; }};

/// Whether an entry that may be auto is a number.
bool isNumber(const Dictionary& dict, const Key& key)
{
    return dict.has(key) && !(dict.tokens(key).size() == 1 && dict.tokens(key)[0].text == "auto");
}

} // namespace fluidProperties

} // namespace

Key viscosityWallsKey()
{
    return fluidProperties::walls;
}

Keys fluidPropertiesKeysBeside(const Key& viscosity)
{
    using namespace fluidProperties;
    return {rho0, equationOfState, viscosity, friction};
}

FluidProperties FluidProperties::read(const Dictionary& dict)
{
    using namespace fluidProperties;
    FluidProperties fluid;
    fluid.rho0 = dict.scalar(fluidProperties::rho0);

    const Dictionary state = dict.dictOr(fluidProperties::equationOfState);
    state.choice(equation, "equation of state");
    fluid.gamma = state.scalar(fluidProperties::gamma);
    if (isNumber(state, fluidProperties::speedOfSound))
    {
        fluid.speedOfSound = state.scalar(fluidProperties::speedOfSound);
    }
    state.refuseUnknown(fluidProperties::equationOfState.entries());

    const Dictionary viscosity = dict.dict("viscosity"); // the rest is viscosities/'s
    fluid.slip = viscosity.has(walls) && viscosity.choice(walls, "wall condition") == "slip";

    const Dictionary layers = dict.dictOr(fluidProperties::friction);
    if (layers.choice(frictionType, "friction type") == "boundaryLayer")
    {
        if (!fluid.slip)
        {
            throw layers.errorAt(
                "type", "is boundaryLayer, but walls noSlip of viscosity already acts as friction; expected walls slip "
                        "in viscosity"
            );
        }
        fluid.friction.boundaryLayers = true;
        fluid.friction.nu = layers.scalar(nu);
        const Dictionary slice = layers.dictOr(sideWalls);
        fluid.friction.breadth = slice.scalarOr(breadth, 0);
        if (fluid.friction.breadth > 0 && isNumber(slice, omega))
        {
            fluid.friction.omega = slice.scalar(omega);
        }
        slice.refuseUnknown(sideWalls.entries());
    }
    layers.refuseUnknown(fluidProperties::friction.entries());
    dict.refuseUnknown(fluidPropertiesKeysBeside({.name = "viscosity"}));
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
            "constant/fluidProperties: sideWalls of friction is set for a 3D tank; expected a 2D tank",
            CaseError::Kind::input
        );
    }
    const auto omegas = friction.omega ? std::vector{*friction.omega} : tank.naturalFrequencies(gravity.norm(), 1);
    if (omegas.empty())
    {
        throw CaseError(
            "constant/fluidProperties: omega of sideWalls is auto, but the natural frequency of this tank is not "
            "known; "
            "expected the frequency of the motion [rad/s]",
            CaseError::Kind::input
        );
    }
    return 2 * std::sqrt(friction.nu * omegas.front() / 2) / friction.breadth;
}

TaitEquation FluidProperties::equationOfState(const Tank& tank, const Vec& gravity, double automatic) const
{
    TaitEquation state{rho0, speedOfSound.value_or(automatic), gamma};
    if (!(state.c0 > 0))
    {
        throw CaseError(
            "constant/fluidProperties: speedOfSound is auto, but there is no gravity and the tank is at rest; expected "
            "ten times the largest speed of the liquid [m/s]",
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

double
automaticSpeedOfSound(const Tank& tank, const Vec& gravity, const SolidBodyMotion& motion, bool liquidRestsInTank)
{
    BoundingBox box = tank.box();
    if (const int empty = tank.emptyDirection(); empty >= 0)
    {
        box.min()[empty] = box.max()[empty] = tank.box().center()[empty];
    }
    const double wallSpeed = motion.greatestSpeed(box, std::min(100.0, motion.lastTime()), 4000, liquidRestsInTank);
    return 10 * (std::sqrt(gravity.norm() * tank.fillDepth()) + wallSpeed);
}

} // namespace slosh
