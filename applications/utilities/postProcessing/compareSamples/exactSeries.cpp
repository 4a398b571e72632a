// SPDX-License-Identifier: GPL-3.0-or-later
#include "exactSeries.hpp"

#include "fluid/FluidProperties.hpp"
#include "geometry/Tank.hpp"
#include "motion/SolidBodyMotion.hpp"
#include "verification/BoxSloshing.hpp"
#include "verification/LinearSloshing.hpp"
#include "verification/NonlinearSloshing.hpp"
#include "verification/StretchingDrop.hpp"
#include "verification/StretchingPatch.hpp"
#include "verification/ViscousStandingWave.hpp"

#include <cmath>
#include <memory>
#include <numbers>
#include <utility>

namespace slosh
{

namespace
{

namespace exactReference
{

constexpr Option eta{.name = "eta", .sentence = "surface elevation above the still water level, [m]"};
constexpr Option pressure{.name = "p", .sentence = "pressure, [Pa]"};
constexpr Option pressureInCentre{.name = "p", .sentence = "pressure in the centre, [Pa]"};

constexpr Key location{
    .name = "location", .example = "(0 0.45 0.2)", .unit = unit::metre, .sentence = "(x y z) in the tank"};
constexpr Key start{
    .name = "start",
    .otherwise = "atRest",
    .sentence = "state of the liquid at t = 0",
    .options = []
    {
        return Options{
            {"atRest", "at rest in the inertial frame; the tank's velocity jumps from 0"},
            {"withTank", "moving with the tank"}};
    }};

constexpr Key etaOrPressure{.name = "field", .example = "eta", .options = [] { return Options{eta, pressure}; }};
constexpr Key elevation{.name = "field", .example = "eta", .options = [] { return Options{eta}; }};

constexpr Key modes{.name = "modes", .otherwise = "64", .range = positive, .sentence = "cosine modes of the surface"};
constexpr Key order{
    .name = "order", .otherwise = "5", .range = positive, .sentence = "order in the amplitude; 1 is linear theory"};

constexpr Key mode{.name = "mode", .otherwise = "1", .range = positive};
constexpr Key velocity{
    .name = "velocity",
    .example = "0.01",
    .unit = unit::velocity,
    .sentence = "upward velocity of the surface at the lower wall at t = 0"};
constexpr Key nu{
    .name = "nu",
    .example = "0.005",
    .unit = unit::kinematicViscosity,
    .range = positive,
    .sentence = "kinematic viscosity"};

constexpr Key patchField{
    .name = "field", .example = "a", .options = [] {
        return Options{{"a", "horizontal semi-axis, [m]"}, {"b", "vertical semi-axis, [m]"}, pressureInCentre};
    }};
constexpr Key dropField{
    .name = "field", .example = "a", .options = [] {
        return Options{{"a", "semi-axis along x and y, [m]"}, {"c", "semi-axis along z, [m]"}, pressureInCentre};
    }};
constexpr Key patchRate{
    .name = "A0", .example = "1", .range = positive, .sentence = "rate of stretching at t = 0, [1/s]"};
constexpr Key dropRate{
    .name = "A0",
    .example = "1",
    .sentence = "rate of stretching at t = 0, [1/s]; its sign decides whether the drop lengthens or flattens"};
constexpr Key R{.name = "R", .example = "1", .unit = unit::metre, .range = positive, .sentence = "radius at t = 0"};

} // namespace exactReference

double density(const Case& theCase)
{
    return FluidProperties::read(theCase.dictionary("constant/fluidProperties")).rho0;
}

template <class F>
TimeSeries evaluated(const TimeSeries& samples, const F& f)
{
    TimeSeries exact = samples;
    for (std::size_t i = 0; i < exact.size(); ++i)
    {
        exact.value[i] = f(exact.t[i]);
    }
    return exact;
}

/// The motion seen by the linear theory of the plane of `direction` and the vertical: of the middle of the still
/// surface, about which the tank rolls.
SwayAndRoll motionAlong(int direction, const std::shared_ptr<const SolidBodyMotion>& motion, const Vec& surface)
{
    SwayAndRoll seen;
    seen.sway = [=](const Jet& t)
    {
        const RigidState state = motion->at(t.f);
        return Jet(
            (state.pointToInertial(surface) - surface)[direction], state.velocityAt(surface)[direction],
            state.accelerationAt(surface)[direction]
        );
    };
    // Towards the vertical: about +x along y, about -y along x.
    const int axis = direction == 1 ? 0 : 1;
    const double sign = direction == 1 ? 1 : -1;
    seen.roll = [=](const Jet& t)
    {
        const RigidState state = motion->at(t.f);
        return Jet(std::asin(state.R(2, direction)), sign * state.omega[axis], sign * state.omegaDot[axis]);
    };
    return seen;
}

/// A case's tank, which `dict` asks a theory of waves about.
Tank tankOfWaves(const Dictionary& dict, const Case& theCase)
{
    Tank tank = Tank::read(theCase.dictionary("constant/tankProperties"));
    if (!tank.fill().fromWallToWall() || !tank.bodies().empty())
    {
        throw dict.errorAt(
            "type", "is " + dict.word("type") + "; expected a tank filled from wall to wall without bodies"
        );
    }
    if (!tank.liquidIsBox())
    {
        throw dict.errorAt(
            "type", "is " + dict.word("type") + " for liquid in a " + tank.walls().name() +
                        "; expected liquid in the form of a box"
        );
    }
    return tank;
}

/// What sloshing in a case's tank begins with.
struct Sloshing
{
    Tank tank;
    double g, rho;
    Start start;
    std::shared_ptr<const SolidBodyMotion> motion;
    Vec surface; ///< the middle of the still one, [m]
    Vec local;   ///< `location` from there, [m]

    RectangularTank plane(int direction) const
    {
        return {.L = tank.boxUnderSurface()->sizes()[direction], .h = tank.fillDepth(), .g = g, .rho = rho};
    }
};

Sloshing readSloshing(const Dictionary& dict, const Case& theCase)
{
    Tank tank = tankOfWaves(dict, theCase);
    const Start start = dict.choice(exactReference::start, "start") == "atRest" ? Start::atRest : Start::withTank;
    Vec surface = tank.boxUnderSurface()->center();
    surface.z() = tank.fill().level();
    const Vec local = dict.vector(exactReference::location) - surface;
    return {
        std::move(tank),
        theCase.gravity().norm(),
        density(theCase),
        start,
        SolidBodyMotion::read(theCase.dictionaryIfPresent("constant/dynamicMeshDict"), theCase.root().string()),
        surface,
        local};
}

/// Surface elevation above the still level, [m], or pressure, [Pa], at `location` in the tank, to first order in the
/// motion: a 2D tank filled from wall to wall without bodies, or a 3D one that sways.
TimeSeries linearSloshing(const Dictionary& dict, const Case& theCase, const TimeSeries& samples)
{
    const bool pressure = dict.choice(exactReference::etaOrPressure, "field") == "p";
    const Sloshing the = readSloshing(dict, theCase);
    const Vec& local = the.local;
    const auto along = [&](int direction)
    { return LinearSloshing(the.plane(direction), motionAlong(direction, the.motion, the.surface), the.start); };
    if (the.tank.dim() == 2)
    {
        const int direction = the.tank.directions().front();
        LinearSloshing exact = along(direction);
        return evaluated(
            samples, [&](double t)
            { return pressure ? exact.pressure(local[direction], local.z(), t) : exact.eta(local[direction], t); }
        );
    }
    BoxSloshing exact(along(0), along(1));
    return evaluated(
        samples, [&](double t)
        { return pressure ? exact.pressure(local.x(), local.y(), local.z(), t) : exact.eta(local.x(), local.y(), t); }
    );
}

/// Surface elevation as above of nonlinear potential flow: a 2D tank that sways.
TimeSeries nonlinearSloshing(const Dictionary& dict, const Case& theCase, const TimeSeries& samples)
{
    dict.choice(exactReference::elevation, "field");
    const SpectralResolution resolution{
        .modes = static_cast<int>(dict.label(exactReference::modes)),
        .order = static_cast<int>(dict.label(exactReference::order))};
    const Sloshing the = readSloshing(dict, theCase);
    if (the.tank.dim() != 2)
    {
        throw dict.errorAt("type", "is nonlinearSloshing for a 3D tank; expected a 2D tank");
    }
    const int direction = the.tank.directions().front();
    NonlinearSloshing exact(
        the.plane(direction), motionAlong(direction, the.motion, the.surface).sway, the.start, resolution
    );
    return evaluated(
        samples,
        [&](double t)
        {
            const RigidState tank = the.motion->at(t);
            if (!tank.R.isIdentity() || std::abs(tank.accelerationAt(the.surface).z()) > 1e-9)
            {
                throw dict.errorAt("type", "is nonlinearSloshing, but the motion is not sway; expected a swaying tank");
            }
            return exact.eta(the.local[direction], t);
        }
    );
}

/// Surface elevation of the standing wave `mode` of a liquid of viscosity `nu` between walls along which it slips, set
/// in motion with `velocity` at the lower wall from its flat state, [m]: a 2D tank at rest without bodies.
TimeSeries viscousStandingWave(const Dictionary& dict, const Case& theCase, const TimeSeries& samples)
{
    dict.choice(exactReference::elevation, "field");
    const Tank tank = tankOfWaves(dict, theCase);
    if (tank.dim() != 2)
    {
        throw dict.errorAt("type", "is viscousStandingWave for a 3D tank; expected a 2D tank");
    }
    if (!SolidBodyMotion::read(theCase.dictionaryIfPresent("constant/dynamicMeshDict"), theCase.root().string())
             ->isStationary())
    {
        throw dict.errorAt("type", "is viscousStandingWave for a moving tank; expected a tank at rest");
    }
    const int direction = tank.directions().front();
    const double k = static_cast<double>(dict.label(exactReference::mode)) * std::numbers::pi /
                     tank.boxUnderSurface()->sizes()[direction];
    const double fromWall = dict.vector(exactReference::location)[direction] - tank.boxUnderSurface()->min()[direction];
    const double rise = dict.scalar(exactReference::velocity) * std::cos(k * fromWall);
    const ViscousStandingWave wave(k, tank.fillDepth(), theCase.gravity().norm(), dict.scalar(exactReference::nu));
    return evaluated(samples, [&](double t) { return rise * wave.etaSetInMotion(t); });
}

/// Semi-axes or central pressure of the patch v = (-A0 x, A0 z).
TimeSeries stretchingPatch(const Dictionary& dict, const Case& theCase, const TimeSeries& samples)
{
    const std::string field = dict.choice(exactReference::patchField, "field");
    const StretchingPatch exact(
        dict.scalar(exactReference::patchRate), dict.scalar(exactReference::R), density(theCase)
    );
    return evaluated(
        samples,
        [&](double t)
        {
            const StretchedPatch patch = exact.at(t);
            return field == "a" ? patch.a : field == "b" ? patch.b : patch.pc;
        }
    );
}

/// The same of the drop v = (-A0 x/2, -A0 y/2, A0 z).
TimeSeries stretchingDrop(const Dictionary& dict, const Case& theCase, const TimeSeries& samples)
{
    const std::string field = dict.choice(exactReference::dropField, "field");
    const StretchingDrop exact(dict.scalar(exactReference::dropRate), dict.scalar(exactReference::R), density(theCase));
    return evaluated(
        samples,
        [&](double t)
        {
            const StretchedDrop drop = exact.at(t);
            return field == "a" ? drop.a : field == "c" ? drop.c : drop.pc;
        }
    );
}

} // namespace

const std::vector<ExactSeries>& exactSeries()
{
    using namespace exactReference;
    static const std::vector<ExactSeries> table = {
        {"linearSloshing",
         "linear theory for the case's tank and motion: a 2D tank filled from wall to wall without bodies, or a "
         "swaying 3D tank",
         linearSloshing,
         [] {
             return Keys{etaOrPressure, location, start};
         }},
        {"nonlinearSloshing", "potential flow of finite amplitude: a 2D tank in pure sway", nonlinearSloshing,
         [] {
             return Keys{elevation, location, start, modes, order};
         }},
        {"viscousStandingWave", "a 2D tank at rest with slip walls", viscousStandingWave,
         [] {
             return Keys{elevation, location, mode, velocity, nu};
         }},
        {"stretchingPatch", "v = (-A0 x, A0 z) at t = 0, in the case's plane", stretchingPatch,
         [] {
             return Keys{patchField, patchRate, R};
         }},
        {"stretchingDrop", "v = (-A0 x/2, -A0 y/2, A0 z) at t = 0", stretchingDrop, [] {
             return Keys{dropField, dropRate, R};
         }}};
    return table;
}

} // namespace slosh
