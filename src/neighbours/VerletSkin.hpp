#pragma once

#include "base/Vec.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace slosh
{

/// Tells when Verlet lists must be rebuilt: a pair can have come nearer by no more than the two largest displacements
/// d1 + d2 since the list was built, so the lists hold while d1 + d2 <= skin. Two particles decide, not twice the
/// fastest: one droplet in flight costs half the rebuilds it would otherwise.
class VerletSkin
{
public:
    /// skin/supportRadius that costs least in a rolling tank: fewer rebuilds against longer rows (docs/performance.md).
    static constexpr double usualRatio = 0.15;

    explicit VerletSkin(double skin = 0) : skin_(skin) {}

    double skin() const { return skin_; }

    /// Notes the positions a list was built with.
    void listBuilt(std::span<const Vec> positions) { listed_.assign(positions.begin(), positions.end()); }

    /// True where d1 + d2 + allowance > skin; `allowance`: how much nearer two particles may come before the next
    /// question, [m]. True for a list never built, too.
    bool mustRebuild(std::span<const Vec> positions, double allowance) const;

    void forget() { listed_.clear(); }

private:
    double skin_;
    std::vector<Vec> listed_;
};

} // namespace slosh
