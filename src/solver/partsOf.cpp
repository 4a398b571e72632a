// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/partsOf.hpp"

#include "physics/makeInteractions.hpp"

namespace slosh
{

std::unique_ptr<Interactions> interactionsOf(const Scene& scene, const Schemes& schemes)
{
    const double h = scene.kernel.smoothingLength();
    return makeInteractions(
        PairGeometry::of(scene.tank.directions(), h), scene.kernel.choice(),
        {scene.viscosity, chooseDensityDiffusion(schemes.densityDiffusion, scene.equationOfState), scene.fluid.slip},
        schemes.precision
    );
}

std::optional<AcousticDamper>
soundDamper(const Scene& scene, const Schemes& schemes, double particleSpacing, const std::vector<double>& state)
{
    if (schemes.soundDamping == 0)
    {
        return std::nullopt;
    }
    const double L =
        schemes.dampingLength > 0 ? schemes.dampingLength : AcousticDamper::length(scene.tank, particleSpacing);
    return AcousticDamper(
        scene.tank, L, schemes.soundDamping * L * scene.equationOfState.c0, scene.equationOfState.rho0, state
    );
}

} // namespace slosh
