// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/stepLimits.hpp"

#include "fluid/FluidProperties.hpp"
#include "integration/timeStep.hpp"
#include "particles/reduce.hpp"
#include "solver/soundness.hpp"

#include <cmath>
#include <limits>
#include <sstream>

namespace slosh
{

double maxCoOfStiffLiquid(const Scene& scene)
{
    const double wanted = scene.automaticSpeedOfSound;
    const double c0 = scene.equationOfState.c0;
    const bool stiff = !scene.gravity.isZero() && wanted > 0 && c0 > 10 * wanted;
    return stiff ? 8 * wanted / c0 : std::numeric_limits<double>::infinity();
}

double kinematicViscosity(const Scene& scene, double factor)
{
    return std::visit(
        [&](const auto& viscosity)
        { return viscosity.kinematic(scene.tank.dim(), scene.kernel.smoothingLength(), factor); },
        scene.viscosity
    );
}

double longestTimeStep(const Scene& scene, double viscosityFactor, double maxCo)
{
    return stableTimeStep(
        maxCo, scene.kernel.smoothingLength(), scene.equationOfState.c0, 0, 0,
        kinematicViscosity(scene, viscosityFactor)
    );
}

double stableTimeStep(
    const Scene& scene, const Particles& particles, const Rates& rates, double maxSpeed, double viscosityFactor,
    double maxCo
)
{
    // One that is not a number is left to the step, which says which particle it is.
    const auto acceleration2 = [&](std::ptrdiff_t i)
    {
        const double a2 = rates.acceleration[i].squaredNorm();
        return a2 == a2 ? a2 : 0;
    };
    const double maxAcceleration = std::sqrt(maxOverLiquid(particles, acceleration2));
    const double dt = stableTimeStep(
        maxCo, scene.kernel.smoothingLength(), scene.equationOfState.c0, maxSpeed, maxAcceleration,
        kinematicViscosity(scene, viscosityFactor)
    );
    if (!(dt > 1e-3 * longestTimeStep(scene, viscosityFactor, maxCo)))
    {
        std::ostringstream message;
        message << "the time step has collapsed to " << dt << " s: the largest acceleration is " << maxAcceleration
                << " m/s^2, the largest speed " << maxSpeed
                << " m/s.\nA smaller maxCo (system/controlDict), more viscosity or a smaller particleSpacing may help";
        throw UnphysicalRun(message.str());
    }
    return dt;
}

void requireStableStep(const Scene& scene, const Schemes& schemes, const Controls& time)
{
    const double most = schemes.maxCourantNumber;
    const double longest = most * scene.kernel.smoothingLength() / scene.equationOfState.c0;
    std::ostringstream what;
    if (time.adjustTimeStep() && time.maxCo() > most && time.maxDeltaT() > longest)
    {
        what << "is " << time.maxCo() << "; expected at most " << most;
    }
    else if (!time.adjustTimeStep() && time.fixedDeltaT() > longest)
    {
        what << "is " << time.fixedDeltaT() << " s; expected at most " << longest << " s, " << most << " h/c0";
    }
    else
    {
        return;
    }
    what << ", limits courantNumber of system/sphSchemes (docs/stability.md)";
    throw time.dictionary().errorAt(time.adjustTimeStep() ? "maxCo" : "deltaT", what.str());
}

} // namespace slosh
