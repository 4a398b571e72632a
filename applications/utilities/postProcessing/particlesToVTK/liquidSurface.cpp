// SPDX-License-Identifier: GPL-3.0-or-later
#include "liquidSurface.hpp"

#include "sampling/samplePoint.hpp"
#include "sampling/volumeFractionLattice.hpp"

namespace slosh
{

LiquidSurface liquidSurface(const Scene& scene, const Particles& particles, const TimeState& state)
{
    const Snapshot snapshot(scene, particles, state);

    // A hair off the tank's faces: what ends there is kept whatever the rounding, and a body's foot is inside the body.
    const Vec hair = Vec::Constant(1e-3 * particles.spacing);
    const Vec low = scene.tank.box().min() + hair, high = scene.tank.box().max() - hair;
    const auto inside = [&](const Vec& X) { return scene.tank.distanceToWall(X.cwiseMax(low).cwiseMin(high)); };
    LiquidSurface liquid;
    liquid.surface = isoSurface(volumeFractionLattice(snapshot, particles.spacing), 0.5, inside);
    for (Vec& X : liquid.surface.points)
    {
        const LiquidMean mean = liquidMean(snapshot, X);
        liquid.fields.U.push_back(mean.velocity);
        liquid.fields.p.push_back(mean.pressure);
        X = snapshot.frame().fromTank(X);
    }
    for (Vec& n : liquid.surface.normals)
    {
        n = snapshot.frame().fromTankAxes(n);
    }
    return liquid;
}

} // namespace slosh
