// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/startWarnings.hpp"

#include "fluid/FluidProperties.hpp"
#include "integration/TimeIntegrator.hpp"
#include "solver/stepLimits.hpp"

#include <sstream>

namespace slosh
{

std::vector<std::string> startWarnings(const Scene& scene, const Schemes& schemes, const Controls& time)
{
    std::vector<std::string> warnings;
    const auto warn = [&](const auto&... words)
    {
        std::ostringstream text;
        (text << ... << words);
        warnings.push_back(text.str());
    };
    const double c0 = scene.equationOfState.c0;
    const double wanted = automaticSpeedOfSound(scene.tank, scene.gravity, *scene.motion);
    if (c0 < wanted / 2)
    {
        warn(
            "speedOfSound is ", c0, " m/s (constant/fluidProperties), ", 10 * c0 / wanted,
            " times the speed that depth and motion promise, ", wanted / 10, " m/s: the density will be off by ",
            100 * (wanted / c0) * (wanted / c0) / 100, " % or more; 'auto' would be ", wanted, " m/s"
        );
    }
    const double most = maxCoOfStiffLiquid(scene);
    if (time.adjustTimeStep() && (time.maxCoIsLimited() || time.maxCo() > most))
    {
        warn(
            "speedOfSound is ", c0, " m/s (constant/fluidProperties), ", 10 * c0 / wanted,
            " times the speed that depth and motion promise: in a step longer than maxCo ", most,
            " walls that liquid leaves give it energy (docs/stability.md); maxCo is ", time.maxCo(),
            time.maxCoIsLimited() ? ", chosen so" : time.dictionary().placeOf("maxCo"), ", 'auto' would be ", wanted,
            " m/s"
        );
    }
    const double largestStableCo = TimeIntegrator::make(schemes.timeIntegration)->largestStableCo();
    const double longest = largestStableCo * scene.kernel.smoothingLength() / c0;
    if (time.adjustTimeStep() && time.maxCo() > largestStableCo)
    {
        warn(
            "maxCo is ", time.maxCo(), time.dictionary().placeOf("maxCo"), ": beyond the limit of stability, about ",
            largestStableCo, " (docs/stability.md)"
        );
    }
    if (!time.adjustTimeStep() && time.fixedDeltaT() > longest)
    {
        warn(
            "deltaT is ", time.fixedDeltaT(), " s", time.dictionary().placeOf("deltaT"),
            ": beyond the limit of stability, about ", longest, " s (", largestStableCo, " h/c0)"
        );
    }
    return warnings;
}

} // namespace slosh
