// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "neighbours/Clusters.hpp"
#include "particles/Particles.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace slosh
{

/// Verlet lists of clusters: for each liquid particle the clusters in which a particle was nearer than R + s_i + s_j
/// when the list was built. They hold every pair within the support R until a particle has moved by more than its skin
/// s_i (VerletSkin).
///
/// Each pair of liquid stands in one row, whose walk gives to both, and a pair of liquid and wall in that of the
/// liquid. Sums are collected by bricks: each has those of its own clusters and of those of other bricks that its rows
/// reach, and what the bricks have come to is added in their order. So no thread writes to another's sums and the bits
/// do not depend on threads.
class ClusterLists
{
public:
    /// Whether two particles see each other, the same either way: not across a thin plate.
    using Visible = std::function<bool(std::ptrdiff_t, std::ptrdiff_t)>;

    /// The entries of one or two liquid particles: their own cluster, of which they take their own sums alone, `walls`
    /// clusters of walls, and `both` clusters of liquid, which take theirs from them as well.
    struct Row
    {
        std::uint16_t walls, both;
    };

    /// What a thread works on. Clusters have local numbers, of two bytes: [0, own) its own, [own, liquid) others of the
    /// liquid, [liquid, size()) walls. A cluster of which a row does not see all particles has a second number, under
    /// which the others are `hidden`: only plates pay for it.
    struct Brick
    {
        int firstCluster = 0, own = 0, liquid = 0;
        int particlesOfRow = 1;             ///< that follow each other in a cluster; its last row may have less
        std::vector<int> others;            ///< the clusters of the local numbers from `own` on
        std::vector<std::uint8_t> hidden;   ///< lanes, by bits, of the local numbers; none where all see all
        std::vector<Row> rows;              ///< of its particles, cluster after cluster
        std::vector<std::uint16_t> entries; ///< row after row
        std::ptrdiff_t firstSums = 0;       ///< its clusters of liquid in the order of all bricks' sums
        std::ptrdiff_t firstWallSums = 0;   ///< and those of walls
        std::vector<int> reached;           ///< bricks of liquid that it has sums of, with itself
        std::vector<int> reachedWalls;      ///< and bricks of walls

        int size() const { return own + static_cast<int>(others.size()); }
        /// The cluster of a local number.
        int cluster(int local) const { return local < own ? firstCluster + local : others[local - own]; }
    };

    /// Where the sums of clusters are among those of all bricks, in their order.
    struct Sources
    {
        std::vector<std::uint32_t> first, sums;
        std::vector<int> bricks; ///< that have some, by the brick of the clusters
        std::span<const std::uint32_t> of(std::ptrdiff_t cluster) const
        {
            return {sums.data() + first[cluster], sums.data() + first[cluster + 1]};
        }
    };

    /// `liquid`: the clusters of the liquid. `directions`: the components of Vec that are not empty. All pairs nearer
    /// than supportRadius + skins[i] + skins[j], [m], one skin for each particle, that see each other. Unless
    /// `wallsMove`, walls stand where they stood for the list before. Throws CaseError where particles stand so close
    /// that two bytes are too few.
    void build(
        const Particles& particles, Clusters liquid, std::span<const int> directions, double supportRadius,
        std::span<const double> skins, bool wallsMove, const Visible& visible = nullptr
    );
    /// All pairs nearer than `reach`, of particles in any order.
    void
    build(const Particles& particles, std::span<const int> directions, double reach, const Visible& visible = nullptr);

    const Clusters& liquid() const { return liquid_; }
    const Clusters& walls() const { return walls_; }
    const std::vector<Brick>& bricks() const { return bricks_; }
    const Sources& sources() const { return sources_; }
    const Sources& wallSources() const { return wallSources_; }
    /// Clusters of walls that have liquid in reach.
    const std::vector<int>& wallsInReach() const { return wallsInReach_; }
    std::ptrdiff_t sums() const { return sums_; } ///< of all bricks, clusters of liquid
    std::ptrdiff_t wallSums() const { return wallSums_; }

    std::size_t bytes() const;

private:
    void countSums();

    Clusters liquid_, walls_;
    std::vector<Brick> bricks_;
    Sources sources_, wallSources_;
    std::vector<int> wallsInReach_;
    std::ptrdiff_t sums_ = 0, wallSums_ = 0;
};

} // namespace slosh
