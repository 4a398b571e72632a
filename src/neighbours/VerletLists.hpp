// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "neighbours/NeighbourList.hpp"
#include "neighbours/VerletSkin.hpp"

namespace slosh
{

/// Verlet lists that are built anew when the particles have moved too far for them.
class VerletLists
{
public:
    /// Sorts the liquid by cells (sortByCell) and builds lists for rows of `lanes` neighbours where displacements, and
    /// a step of `longestStep` at up to `maxSpeed`, demand it; whether they did.
    bool
    update(Particles& particles, double supportRadius, int lanes, bool wallsMove, double longestStep, double maxSpeed);
    /// The next update builds.
    void forget() { skin_.forget(); }

    const NeighbourList& list() const { return list_; }
    double largestSkin() const { return skin_.largest(); } ///< no particle moves farther while a list holds, [m]
    long rebuilds() const { return rebuilds_; }
    std::size_t bytes() const { return list_.bytes() + skin_.bytes(); }

private:
    NeighbourList list_;
    VerletSkin skin_;
    long rebuilds_ = 0;
};

} // namespace slosh
