// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/soundness.hpp"

#include "base/pointText.hpp"
#include "particles/particlesOutside.hpp"

#include <cmath>
#include <sstream>

namespace slosh
{

Soundness soundness(
    const Particles& particles, const Extremes& extremes, const Scene& scene, const Schemes& schemes,
    const SolverFrame& frame, bool someBehindWalls
)
{
    Soundness found;
    std::ostringstream message;
    if (!(extremes.densityDeviation <= schemes.maxDensityDeviation) || !std::isfinite(extremes.speed))
    {
        const double rho0 = scene.equationOfState.rho0;
        std::size_t i = 0;
        while (std::abs(particles.rho[i] / rho0 - 1) <= schemes.maxDensityDeviation &&
               std::isfinite(particles.v[i].squaredNorm()))
        {
            ++i;
        }
        message << "particle " << particles.id[i] << " at " << text(frame.toTank(particles.r[i]))
                << " in the tank has the density " << particles.rho[i] << " kg/m^3 and the velocity "
                << text(particles.v[i]) << " m/s; the limit is a deviation of " << 100 * schemes.maxDensityDeviation
                << " % from rho0 = " << rho0 << " kg/m^3 (system/sphSchemes: limits densityDeviation)";
    }
    else if (someBehindWalls)
    {
        const auto outside = particlesOutside(scene.tank, particles, frame);
        found.outside = static_cast<long>(outside.size());
        if (found.outside <= schemes.maxParticlesOutside)
        {
            return found;
        }
        const std::ptrdiff_t i = outside.front();
        message << outside.size() << " particles are outside the tank; the limit is " << schemes.maxParticlesOutside
                << " (system/sphSchemes: limits particlesOutside): particle " << particles.id[i] << " at "
                << text(frame.toTank(particles.r[i])) << " in the tank";
    }
    else
    {
        return found;
    }
    message << "\nA smaller maxCo or deltaT (system/controlDict), a larger speedOfSound (constant/fluidProperties) or a"
               "\nsmaller particleSpacing (system/blockParticlesDict) may help";
    found.fault = message.str();
    return found;
}

} // namespace slosh
