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
            "type", "is " + dict.word("type") + ", which knows tanks filled from wall to wall without bodies only,"
        );
    }
    if (!tank.liquidIsBox())
    {
        throw dict.errorAt(
            "type", "is " + dict.word("type") + ", which knows liquid in the form of a box only, not that of this " +
                        tank.walls().name() + ","
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
    const Start start =
        dict.choiceOr("start", "atRest", {"atRest", "withTank"}, "start") == "atRest" ? Start::atRest : Start::withTank;
    Vec surface = tank.boxUnderSurface()->center();
    surface.z() = tank.fill().level();
    const Vec local = dict.vector("location", unit::metre) - surface;
    return {
        std::move(tank),
        theCase.gravity().norm(),
        density(theCase),
        start,
        SolidBodyMotion::read(theCase.dictionaryIfPresent("constant/dynamicMeshDict"), theCase.root().string()),
        surface,
        local};
}

} // namespace

TimeSeries linearSloshing(const Dictionary& dict, const Case& theCase, const TimeSeries& samples)
{
    const bool pressure = dict.choice("field", {"eta", "p"}, "field") == "p";
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

TimeSeries nonlinearSloshing(const Dictionary& dict, const Case& theCase, const TimeSeries& samples)
{
    dict.choice("field", {"eta"}, "field");
    const SpectralResolution resolution{
        .modes = static_cast<int>(dict.labelOr("modes", 64, positive)),
        .order = static_cast<int>(dict.labelOr("order", 5, positive))};
    const Sloshing the = readSloshing(dict, theCase);
    if (the.tank.dim() != 2)
    {
        throw dict.errorAt("type", "is nonlinearSloshing, which knows 2D tanks only,");
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
                throw dict.errorAt("type", "is nonlinearSloshing, which knows tanks that sway only,");
            }
            return exact.eta(the.local[direction], t);
        }
    );
}

TimeSeries viscousStandingWave(const Dictionary& dict, const Case& theCase, const TimeSeries& samples)
{
    dict.choice("field", {"eta"}, "field");
    const Tank tank = tankOfWaves(dict, theCase);
    if (tank.dim() != 2)
    {
        throw dict.errorAt("type", "is viscousStandingWave, which knows 2D tanks only,");
    }
    if (!SolidBodyMotion::read(theCase.dictionaryIfPresent("constant/dynamicMeshDict"), theCase.root().string())
             ->isStationary())
    {
        throw dict.errorAt("type", "is viscousStandingWave, which knows tanks at rest only,");
    }
    const int direction = tank.directions().front();
    const double k = static_cast<double>(dict.labelOr("mode", 1, positive)) * std::numbers::pi /
                     tank.boxUnderSurface()->sizes()[direction];
    const double fromWall = dict.vector("location", unit::metre)[direction] - tank.boxUnderSurface()->min()[direction];
    const double rise = dict.scalar("velocity", unit::velocity) * std::cos(k * fromWall);
    const ViscousStandingWave wave(
        k, tank.fillDepth(), theCase.gravity().norm(), dict.scalar("nu", unit::kinematicViscosity, positive)
    );
    return evaluated(samples, [&](double t) { return rise * wave.etaSetInMotion(t); });
}

TimeSeries stretchingPatch(const Dictionary& dict, const Case& theCase, const TimeSeries& samples)
{
    const std::string field = dict.choice("field", {"a", "b", "p"}, "field");
    const StretchingPatch exact(
        dict.scalar("A0", unit::none, positive), dict.scalar("R", unit::metre, positive), density(theCase)
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

TimeSeries stretchingDrop(const Dictionary& dict, const Case& theCase, const TimeSeries& samples)
{
    const std::string field = dict.choice("field", {"a", "c", "p"}, "field");
    const StretchingDrop exact(
        dict.scalar("A0", unit::none), dict.scalar("R", unit::metre, positive), density(theCase)
    );
    return evaluated(
        samples,
        [&](double t)
        {
            const StretchedDrop drop = exact.at(t);
            return field == "a" ? drop.a : field == "c" ? drop.c : drop.pc;
        }
    );
}

} // namespace slosh
