// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/startParticles.hpp"

#include "base/pointText.hpp"
#include "neighbours/coincident.hpp"
#include "particles/changeFrame.hpp"
#include "physics/FourtakasDensityDiffusion.hpp"
#include "physics/WallFriction.hpp"

#include <algorithm>

namespace slosh
{

namespace
{

void requireOnePlaceEach(const Particles& particles)
{
    // In any frame: nearer than rounding puts them.
    if (const auto pair = coincident(particles, 1e-6 * particles.spacing))
    {
        const auto [a, b] = *pair;
        throw CaseError(
            "particles " + std::to_string(particles.id[a]) + " and " + std::to_string(particles.id[b]) +
                " have the same position, " + text(particles.r[a]) +
                "; expected different ones: do regions of liquid overlap, or were files edited?",
            CaseError::Kind::input
        );
    }
}

/// What the terms of a scheme carry from step to step.
std::vector<Field> rememberedFields(const Scene& scene, const Schemes& schemes)
{
    std::vector<Field> fields;
    if (schemes.densityDiffusion > 0)
    {
        fields.push_back(FourtakasDensityDiffusion::mean());
    }
    if (scene.fluid.friction.boundaryLayers)
    {
        const std::vector<Field> layers = WallFriction::layerFields();
        fields.insert(fields.end(), layers.begin(), layers.end());
    }
    return fields;
}

} // namespace

Particles startParticles(
    const Scene& scene, const Schemes& schemes, Particles particles, const TimeState& start,
    const std::vector<Vec>& wallInTank
)
{
    requireOnePlaceEach(particles);
    WallFriction::requireAllOrNoLayerFields(particles);
    particles.remember(rememberedFields(scene, schemes));
    changeFrame(particles, start.solverFrame(), schemes.frame);
    const SolverFrame frame(schemes.frame, start.tank);
    for (std::ptrdiff_t w = 0; w < particles.nWall; ++w)
    {
        particles.r[particles.nFluid + w] = frame.fromTank(wallInTank[w]);
        particles.v[particles.nFluid + w] = frame.wallVelocity(wallInTank[w]);
    }
    return particles;
}

} // namespace slosh
