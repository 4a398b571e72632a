// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "neighbours/ClusterLists.hpp"
#include "neighbours/VerletSkin.hpp"

#include <utility>
#include <vector>

namespace slosh
{

/// Verlet lists that are built anew when the particles have moved too far for them.
class VerletLists
{
public:
    /// `directions`: the components of Vec that are not empty. R: the support's radius.
    VerletLists(std::vector<int> directions, double supportRadius)
        : directions_(std::move(directions)), supportRadius_(supportRadius)
    {
    }

    /// Sorts the liquid by bricks (sortByBrick) and builds lists where displacements, and a step of `longestStep` at up
    /// to `maxSpeed`, demand it; whether they did.
    bool update(Particles& particles, bool wallsMove, double longestStep, double maxSpeed);
    /// The next update builds.
    void forget() { skin_.forget(); }

    const ClusterLists& list() const { return list_; }
    double largestSkin() const { return skin_.largest(); } ///< no particle moves farther while a list holds, [m]
    long rebuilds() const { return rebuilds_; }
    std::size_t bytes() const { return list_.bytes() + skin_.bytes(); }

private:
    std::vector<int> directions_;
    double supportRadius_;
    ClusterLists list_;
    VerletSkin skin_;
    long rebuilds_ = 0;
};

} // namespace slosh
