// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/startWarnings.hpp"

#include "base/pointText.hpp"
#include "integration/TimeIntegrator.hpp"
#include "solver/stepLimits.hpp"

#include <algorithm>
#include <sstream>

namespace slosh
{

namespace
{

std::string placeAndVelocity(const RigidState& tank, const Vec& X)
{
    return text(tank.pointToInertial(X)) + " m, velocity " + text(tank.velocityAt(X)) + " m/s";
}

/// Whether a corner of the tank is elsewhere, or has another velocity.
bool goesOn(const RigidState& was, const RigidState& is, const BoundingBox& box)
{
    const double L = box.sizes().maxCoeff();
    for (int corner = 0; corner < 8; ++corner)
    {
        const Vec X = box.corner(static_cast<BoundingBox::CornerType>(corner));
        const double speed = std::max(was.velocityAt(X).norm(), is.velocityAt(X).norm());
        if ((was.pointToInertial(X) - is.pointToInertial(X)).norm() > 1e-6 * (L + is.c.norm()) ||
            (was.velocityAt(X) - is.velocityAt(X)).norm() > 1e-6 * speed)
        {
            return false;
        }
    }
    return true;
}

} // namespace

std::vector<std::string>
startWarnings(const Scene& scene, const Schemes& schemes, const Controls& time, const TimeState& start)
{
    std::vector<std::string> warnings;
    const auto warn = [&](const auto&... words)
    {
        std::ostringstream text;
        (text << ... << words);
        warnings.push_back(text.str());
    };
    const std::string& name = time.startName();
    if (start.renamed)
    {
        warn(
            name, "/uniform/time: value is ", *start.renamed, "; the run starts at ", start.time,
            ", the name of the directory"
        );
    }
    const RigidState tank = scene.motion->at(start.time);
    if (const BoundingBox box = scene.tank.box(); !goesOn(start.tank, tank, box))
    {
        const Vec& corner = box.max();
        warn(
            "constant/dynamicMeshDict: the tank jumps at ", start.time, " s: its corner ", text(corner), " is at ",
            placeAndVelocity(tank, corner), "; when ", name, " was written it was at ",
            placeAndVelocity(start.tank, corner)
        );
    }
    const double c0 = scene.equationOfState.c0;
    const double wanted = scene.automaticSpeedOfSound;
    if (c0 < wanted / 2)
    {
        warn(
            "constant/fluidProperties: speedOfSound is ", c0, " m/s, ", 10 * c0 / wanted,
            " times the largest speed expected from depth and motion, ", wanted / 10,
            " m/s: the density error will be ", 100 * (wanted / c0) * (wanted / c0) / 100, " % or more; auto gives ",
            wanted, " m/s"
        );
    }
    const double most = maxCoOfStiffLiquid(scene);
    if (time.adjustTimeStep() && (time.maxCoIsLimited() || time.maxCo() > most))
    {
        warn(
            "constant/fluidProperties: speedOfSound is ", c0, " m/s, ", 10 * c0 / wanted,
            " times the largest speed expected from depth and motion: with maxCo above ", most,
            " walls add energy to liquid that leaves them (docs/stability.md); maxCo is ", time.maxCo(),
            time.maxCoIsLimited() ? ", reduced to that" : " (" + time.dictionary().placeOf("maxCo") + ")",
            "; auto gives ", wanted, " m/s"
        );
    }
    const double largestStableCo = TimeIntegrator::make(schemes.timeIntegration)->largestStableCo();
    const double longest = largestStableCo * scene.kernel.smoothingLength() / c0;
    if (time.adjustTimeStep() && time.maxCo() > largestStableCo)
    {
        warn(
            time.dictionary().placeOf("maxCo"), ": maxCo is ", time.maxCo(), ", above the stability limit of about ",
            largestStableCo, " (docs/stability.md)"
        );
    }
    if (!time.adjustTimeStep() && time.fixedDeltaT() > longest)
    {
        warn(
            time.dictionary().placeOf("deltaT"), ": deltaT is ", time.fixedDeltaT(),
            " s, above the stability limit of about ", longest, " s (", largestStableCo, " h/c0)"
        );
    }
    return warnings;
}

} // namespace slosh
