// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "particles/Particles.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

namespace slosh
{

/// Each particle's own skin s_i: Verlet lists that hold all pairs nearer than R + s_i + s_j hold every pair within the
/// support R as long as no particle has moved by more than s_i. Fast particles, spray, have wide skins, so that they do
/// not bring about the rebuilding of all lists; the bulk has narrow ones, so that rows are short.
class VerletSkin
{
public:
    /// The skin of a pair, s, that costs least for a support of radius R in d dimensions where two particles may come
    /// nearer by `closing` a step, [m]: rows are longer by (1 + s/R)^d, and a rebuild, which costs b steps' sums, is
    /// due every s/closing steps; about s^2 = (b/d) R closing. b/d is 1.2, measured (docs/decisions/0032);
    /// between 0.02 R and 0.3 R.
    static double cheapest(double supportRadius, double closing)
    {
        return std::clamp(std::sqrt(1.2 * supportRadius * closing), 0.02 * supportRadius, 0.3 * supportRadius);
    }

    /// Chooses the skins for lists of these particles, for steps `dt`:
    ///   s_i = (s/3) (|v_i|/u + 3/2) + dt v_max/2,   s = cheapest(R, 2 u dt),   u, v_max: mean and largest |v|,
    /// the first term at most 0.3 R, but enough for one step. The last one is for particles that are hit. Walls that
    /// do not move have none.
    void choose(const Particles& particles, bool wallsMove, double supportRadius, double dt);
    /// s_i, [m], liquid and walls.
    std::span<const double> skins() const { return skins_; }
    double largest() const { return largest_; }

    /// Notes where the particles are for which lists were built with these skins.
    void listBuilt(const Particles& particles);

    /// True where a particle has moved from there by more than its skin, less what it may move until the end of the
    /// next step, dt (|v_i| + v_max/2), v_max of the liquid as it is now, [m/s]. True for a list never built, too.
    bool mustRebuild(const Particles& particles, double dt, double maxSpeed) const;

    void forget() { listed_.clear(); }
    std::size_t bytes() const
    {
        return listed_.capacity() * sizeof(Eigen::Vector3f) + skins_.capacity() * sizeof(double);
    }

private:
    std::vector<double> skins_;
    std::vector<Eigen::Vector3f> listed_; ///< less origin_, of what moves
    Vec origin_ = Vec::Zero();
    double rounding_ = 0; ///< of a distance between these, [m]
    double largest_ = 0;
    bool wallsMove_ = false;
};

} // namespace slosh
