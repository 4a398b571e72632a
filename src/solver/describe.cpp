// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/describe.hpp"

#include "viscosities/readViscosity.hpp"

#include <utility>

namespace slosh
{

std::vector<std::string>
describe(const Interactions& pairs, const Scene& scene, const Schemes& schemes, bool keepsBudget)
{
    const bool isStill = scene.motion->isStationary();
    const std::pair<bool, const char*> parts[] = {
        {scene.tank.dim() == 2, "the empty direction"},
        {isNone(scene.viscosity), "viscosity"},
        {!scene.fluid.friction.boundaryLayers, "friction at walls"},
        {schemes.soundDamping == 0, "sound damping"},
        {schemes.densityDiffusion == 0, "density diffusion"},
        {isStill, "the tank's motion and its fictitious forces"},
        {!isStill && schemes.frame == Frame::tank, "moving the walls (tank frame)"},
        {schemes.densityInterval == 0, "density re-initialisation"},
        {scene.tank.bodies().empty(), "bodies in the tank"},
        {schemes.precision == Precision::single, "double precision of sums over pairs"},
        {!keepsBudget, "the energy budget"},
        {true, "wall particles out of reach of the liquid"}};
    std::vector<std::string> lines = {"pair loop: " + pairs.description()};
    for (const auto& [isLeftOut, part] : parts)
    {
        if (isLeftOut)
        {
            lines.push_back(std::string("omitted: ") + part);
        }
    }
    return lines;
}

} // namespace slosh
