#pragma once

#include "base/Vec.hpp"

#include <algorithm>
#include <cmath>
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
    /// The skin s that costs least for a support of radius R in d dimensions where two particles may come nearer by
    /// `closing` a step, [m]: rows are longer by (1 + s/R)^d, and a rebuild, which costs b steps' sums, is due every
    /// s/closing steps; about s^2 = (b/d) R closing. b/d is 1.2, measured in 2D (docs/performance.md); between 0.02 R
    /// and 0.3 R.
    static double cheapest(double supportRadius, double closing)
    {
        return std::clamp(std::sqrt(1.2 * supportRadius * closing), 0.02 * supportRadius, 0.3 * supportRadius);
    }

    /// Notes the positions a list with this skin was built with.
    void listBuilt(std::span<const Vec> positions, double skin);

    /// True where d1 + d2 + allowance > skin; `allowance`: how much nearer two particles may come before the next
    /// question, [m]. True for a list never built, too.
    bool mustRebuild(std::span<const Vec> positions, double allowance) const;

    void forget() { listed_.clear(); }

private:
    double skin_ = 0;
    std::vector<Vec> listed_;
};

} // namespace slosh
