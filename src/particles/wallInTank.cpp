// SPDX-License-Identifier: GPL-3.0-or-later
#include "particles/wallInTank.hpp"

#include "particles/particleFiles.hpp"

#include <algorithm>

namespace slosh
{

std::vector<Vec> wallInTank(const Case& theCase, const Particles& particles)
{
    const std::string first = theCase.times().front().name;
    TimeState state;
    const Particles start = readTime(theCase, first, state);
    const bool sameWalls =
        start.nWall == particles.nWall &&
        std::equal(start.id.begin() + start.nFluid, start.id.end(), particles.id.begin() + particles.nFluid);
    if (state.frame != Frame::tank || !sameWalls)
    {
        throw CaseError(
            first + ": the first time directory does not contain these walls in the tank's frame; expected time 0 as "
                    "written by blockParticles",
            CaseError::Kind::input
        );
    }
    return {start.r.begin() + start.nFluid, start.r.end()};
}

} // namespace slosh
