#include "exactSeries.hpp"

#include "geometry/Tank.hpp"
#include "motion/SolidBodyMotion.hpp"
#include "particles/FluidProperties.hpp"
#include "verification/BoxSloshing.hpp"
#include "verification/LinearSloshing.hpp"
#include "verification/StretchingDrop.hpp"
#include "verification/StretchingPatch.hpp"

#include <cmath>
#include <memory>

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
TankMotion motionAlong(int direction, const std::shared_ptr<const SolidBodyMotion>& motion, const Vec& surface)
{
    TankMotion seen;
    seen.sway = [=](const Jet& t)
    {
        const RigidState state = motion->at(t.f);
        return Jet((state.pointToInertial(surface) - surface)[direction], state.velocityAt(surface)[direction],
                   state.accelerationAt(surface)[direction]);
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

} // namespace

TimeSeries linearSloshing(const Dictionary& dict, const Case& theCase, const TimeSeries& samples)
{
    const Tank tank = Tank::read(theCase.dictionary("constant/tankProperties"));
    if (!tank.fill().fromWallToWall() || !tank.bodies().empty())
    {
        throw dict.errorAt("type",
                           "is linearSloshing, which knows tanks filled from wall to wall without bodies only,");
    }
    const bool pressure = dict.choice("field", {"eta", "p"}, "field") == "p";
    const Start start =
        dict.choiceOr("start", "atRest", {"atRest", "withTank"}, "start") == "atRest" ? Start::atRest : Start::withTank;
    const Vec at = dict.vector("location", unit::metre);
    const double g = theCase.gravity().norm(), rho = density(theCase), level = tank.fill().level();
    const std::shared_ptr<const SolidBodyMotion> motion =
        SolidBodyMotion::read(theCase.dictionaryIfPresent("constant/dynamicMeshDict"), theCase.root().string());
    Vec surface = tank.box().center();
    surface.z() = level;
    const auto along = [&](int direction)
    {
        return LinearSloshing({tank.box().sizes()[direction], tank.fillDepth(), g, rho},
                              motionAlong(direction, motion, surface), start);
    };
    const Vec local = at - surface;
    if (tank.dim() == 2)
    {
        const int direction = tank.directions().front();
        LinearSloshing exact = along(direction);
        return evaluated(
            samples, [&](double t)
            { return pressure ? exact.pressure(local[direction], local.z(), t) : exact.eta(local[direction], t); });
    }
    BoxSloshing exact(along(0), along(1));
    return evaluated(
        samples, [&](double t)
        { return pressure ? exact.pressure(local.x(), local.y(), local.z(), t) : exact.eta(local.x(), local.y(), t); });
}

TimeSeries stretchingPatch(const Dictionary& dict, const Case& theCase, const TimeSeries& samples)
{
    const std::string field = dict.choice("field", {"a", "b", "p"}, "field");
    const StretchingPatch exact(dict.scalar("A0", unit::none, positive), dict.scalar("R", unit::metre, positive),
                                density(theCase));
    return evaluated(samples,
                     [&](double t)
                     {
                         const StretchedPatch patch = exact.at(t);
                         return field == "a" ? patch.a : field == "b" ? patch.b : patch.pc;
                     });
}

TimeSeries stretchingDrop(const Dictionary& dict, const Case& theCase, const TimeSeries& samples)
{
    const std::string field = dict.choice("field", {"a", "c", "p"}, "field");
    const StretchingDrop exact(dict.scalar("A0", unit::none), dict.scalar("R", unit::metre, positive),
                               density(theCase));
    return evaluated(samples,
                     [&](double t)
                     {
                         const StretchedDrop drop = exact.at(t);
                         return field == "a" ? drop.a : field == "c" ? drop.c : drop.pc;
                     });
}

} // namespace slosh
