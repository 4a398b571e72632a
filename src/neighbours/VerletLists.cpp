// SPDX-License-Identifier: GPL-3.0-or-later
#include "neighbours/VerletLists.hpp"

#include "neighbours/sortByBrick.hpp"

namespace slosh
{

bool VerletLists::update(Particles& particles, bool wallsMove, double longestStep, double maxSpeed)
{
    if (!skin_.mustRebuild(particles, longestStep, maxSpeed))
    {
        return false;
    }
    // Not by the reach: where particles stand shall be a function of them alone.
    Clusters liquid =
        sortByBrick(particles, brickEdge(particles, static_cast<int>(directions_.size()), supportRadius_));
    skin_.choose(particles, wallsMove, supportRadius_, longestStep);
    list_.build(particles, std::move(liquid), directions_, supportRadius_, skin_.skins(), wallsMove);
    skin_.listBuilt(particles);
    ++rebuilds_;
    return true;
}

} // namespace slosh
