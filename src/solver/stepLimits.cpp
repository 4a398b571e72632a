// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/stepLimits.hpp"

#include "fluid/FluidProperties.hpp"

#include <limits>
#include <sstream>

namespace slosh
{

double maxCoOfStiffLiquid(const Scene& scene)
{
    const double wanted = automaticSpeedOfSound(scene.tank, scene.gravity, *scene.motion);
    const double c0 = scene.equationOfState.c0;
    const bool stiff = !scene.gravity.isZero() && c0 > 10 * wanted;
    return stiff ? 8 * wanted / c0 : std::numeric_limits<double>::infinity();
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
    what << ", limits courantNumber of system/sphSchemes (docs/stability.md):";
    throw time.dictionary().errorAt(time.adjustTimeStep() ? "maxCo" : "deltaT", what.str());
}

} // namespace slosh
