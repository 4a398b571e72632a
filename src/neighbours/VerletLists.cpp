// SPDX-License-Identifier: GPL-3.0-or-later
#include "neighbours/VerletLists.hpp"

#include "neighbours/sortByCell.hpp"

namespace slosh
{

bool VerletLists::update(
    Particles& particles, double supportRadius, int lanes, bool wallsMove, double longestStep, double maxSpeed
)
{
    if (!skin_.mustRebuild(particles, longestStep, maxSpeed))
    {
        return false;
    }
    sortByCell(particles, supportRadius); // not by the reach: where particles stand shall be a function of them alone
    skin_.choose(particles, wallsMove, supportRadius, longestStep);
    list_.build(particles, supportRadius, skin_.skins(), lanes);
    skin_.listBuilt(particles);
    ++rebuilds_;
    return true;
}

} // namespace slosh
