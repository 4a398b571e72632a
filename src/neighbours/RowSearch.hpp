// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/simd.hpp"
#include "neighbours/ClusterLists.hpp"
#include "neighbours/ListedPoints.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <utility>
#include <vector>

namespace slosh
{

/// Finds the rows of one brick.
template <int dim>
class RowSearch
{
    using S = Simd<float>;
    using Cell = Clusters::Cell;

public:
    RowSearch(
        const Clusters& liquid, const Clusters& walls, const ListedPoints<dim>& liquidPoints,
        const ListedPoints<dim>& wallPoints, float reach, double farthest
    )
        : liquid_(liquid), walls_(walls), liquidPoints_(liquidPoints), wallPoints_(wallPoints), reach_(reach),
          farthest_(farthest)
    {
    }

    /// Whether local numbers fit into two bytes.
    bool fill(ClusterLists::Brick& brick, std::ptrdiff_t b, const ClusterLists::Visible& visible)
    {
        brick = {};
        brick.firstCluster = liquid_.firstCluster(b);
        brick.own = liquid_.firstCluster(b + 1) - brick.firstCluster;
        brick.particlesOfRow = visible ? 1 : rowsAtATime; // two do not see the same
        findCandidates(b, brick);
        found_.clear();
        views_.clear();
        for (int own = 0; own < brick.own; ++own)
        {
            boxTest(own);
            const int first = liquid_.firstPlace(brick.firstCluster + own);
            const int size = liquid_.pointsIn(brick.firstCluster + own);
            for (int lane = 0; lane < size; lane += brick.particlesOfRow)
            {
                const int last = std::min(lane + brick.particlesOfRow, size) - 1;
                const auto add = [&](int candidate) {
                    visible ? addIfSeen(own, lane, candidate, first + lane, visible)
                            : addIfNear(own, lane, last, candidate);
                };
                add(own);
                const auto beforeWalls = found_.size();
                std::for_each(nearWalls_.begin(), nearWalls_.end(), add);
                const auto beforeBoth = found_.size();
                std::for_each(nearLiquid_.begin(), nearLiquid_.end(), add);
                brick.rows.push_back(
                    {static_cast<std::uint16_t>(beforeBoth - beforeWalls),
                     static_cast<std::uint16_t>(found_.size() - beforeBoth)}
                );
            }
        }
        return number(brick);
    }

private:
    /// The cells whose bricks can have points within `reach` of those of `cell`.
    static std::pair<Cell, Cell> cellsAround(const Cell& cell, double reach, double edge)
    {
        const int far = static_cast<int>(std::ceil(reach / edge));
        return {{cell[0] - far, cell[1] - far, cell[2] - far}, {cell[0] + far, cell[1] + far, cell[2] + far}};
    }

    /// Clusters that can be in reach of the brick: own, other ones of the liquid, walls.
    void findCandidates(std::ptrdiff_t b, const ClusterLists::Brick& brick)
    {
        candidates_.clear();
        const ReachBox<dim>& box = liquidPoints_.brickBox(b);
        for (int c = 0; c < brick.own; ++c)
        {
            candidates_.push_back(brick.firstCluster + c);
        }
        const auto collect = [&](const Clusters& clusters, const ListedPoints<dim>& points, std::ptrdiff_t other)
        {
            if (!points.brickBox(other).reaches(box, reach_))
            {
                return;
            }
            for (int c = clusters.firstCluster(other); c < clusters.firstCluster(other + 1); ++c)
            {
                if (points.box(c).reaches(box, reach_))
                {
                    candidates_.push_back(c);
                }
            }
        };
        const auto [low, high] = cellsAround(liquid_.cell(b), farthest_, liquid_.brickEdge());
        liquid_.forBricks(
            low, high,
            [&](std::ptrdiff_t other)
            {
                if (other > b) // each pair of bricks is worked off by the first of them
                {
                    collect(liquid_, liquidPoints_, other);
                }
            }
        );
        firstWall_ = static_cast<int>(candidates_.size());
        walls_.forBricks(low, high, [&](std::ptrdiff_t other) { collect(walls_, wallPoints_, other); });

        const std::size_t padded = (candidates_.size() + clusterSize - 1) / clusterSize * clusterSize;
        for (std::size_t d = 0; d < dim; ++d)
        {
            low_[d].assign(padded, 1e15F);
            high_[d].assign(padded, 1e15F);
        }
        skin_.assign(padded, 0);
        for (std::size_t k = 0; k < candidates_.size(); ++k)
        {
            const ReachBox<dim>& candidate =
                static_cast<int>(k) < firstWall_ ? liquidPoints_.box(candidates_[k]) : wallPoints_.box(candidates_[k]);
            for (std::size_t d = 0; d < dim; ++d)
            {
                low_[d][k] = candidate.low[d];
                high_[d][k] = candidate.high[d];
            }
            skin_[k] = candidate.skin;
        }
    }

    const typename ListedPoints<dim>::Cluster& cluster(int candidate) const
    {
        return candidate < firstWall_ ? liquidPoints_.cluster(candidates_[candidate])
                                      : wallPoints_.cluster(candidates_[candidate]);
    }

    /// Candidates after `own` whose boxes are in reach of its own.
    void boxTest(int own)
    {
        nearLiquid_.clear();
        nearWalls_.clear();
        const ReachBox<dim>& box = liquidPoints_.box(candidates_[own]);
        const auto size = static_cast<int>(skin_.size());
        for (int k = (own + 1) / clusterSize * clusterSize; k < size; k += clusterSize)
        {
            S gap2(0);
            for (std::size_t d = 0; d < dim; ++d)
            {
                const S below = box.low[d] - S(&high_[d][k], std::experimental::element_aligned);
                const S above = S(&low_[d][k], std::experimental::element_aligned) - box.high[d];
                const S gap = positivePart(std::experimental::max(below, above));
                gap2 = multiplyAdd(gap, gap, gap2);
            }
            const S nearer = (reach_ + box.skin) + S(&skin_[k], std::experimental::element_aligned);
            for (unsigned near = whereLess<S>(gap2, nearer * nearer); near != 0; near &= near - 1)
            {
                const int candidate = k + std::countr_zero(near);
                if (candidate > own)
                {
                    (candidate < firstWall_ ? nearLiquid_ : nearWalls_).push_back(candidate);
                }
            }
        }
    }

    /// The particles of a candidate in reach of one of the brick's, by bits.
    unsigned lanesInReach(int own, int lane, int candidate) const
    {
        const auto& a = cluster(own);
        const auto& b = cluster(candidate);
        S distance2(0);
        for (std::size_t d = 0; d < dim; ++d)
        {
            const S x = a.x[d][lane] - S(b.x[d].data(), std::experimental::element_aligned);
            distance2 = multiplyAdd(x, x, distance2);
        }
        const S nearer = (reach_ + a.skin[lane]) + S(b.skin.data(), std::experimental::element_aligned);
        return whereLess<S>(distance2, nearer * nearer);
    }

    void addIfNear(int own, int lane, int last, int candidate)
    {
        if (candidate == own || lanesInReach(own, lane, candidate) != 0 || // itself it sees wherever it is
            (last != lane && lanesInReach(own, last, candidate) != 0))
        {
            found_.push_back(candidate);
        }
    }

    void addIfSeen(int own, int lane, int candidate, int place, const ClusterLists::Visible& visible)
    {
        const unsigned itself = candidate == own ? 1U << static_cast<unsigned>(lane) : 0; // wherever it is
        const unsigned near = lanesInReach(own, lane, candidate) | itself;
        if (near == 0)
        {
            return;
        }
        const Clusters& of = candidate < firstWall_ ? liquid_ : walls_;
        const int before = candidate < firstWall_ ? 0 : firstWallParticle_;
        unsigned hidden = 0;
        for (unsigned left = near; left != 0; left &= left - 1)
        {
            const int k = std::countr_zero(left);
            const int a = liquid_.point(place), b = before + of.point(of.firstPlace(candidates_[candidate]) + k);
            if ((candidate != own || k != lane) && !visible(a, b))
            {
                hidden |= 1U << static_cast<unsigned>(k);
            }
        }
        if (hidden == near)
        {
            return;
        }
        if (hidden == 0)
        {
            found_.push_back(candidate);
            return;
        }
        const auto [view, isNew] =
            views_.try_emplace({candidate, hidden}, static_cast<int>(candidates_.size() + views_.size()));
        found_.push_back(view->second);
    }

    /// Local numbers for the candidates that rows have found, in their order; those of which some are hidden follow
    /// those of the same kind.
    bool number(ClusterLists::Brick& brick)
    {
        std::vector<int>& local = local_;
        local.assign(candidates_.size() + views_.size(), -1);
        for (const int candidate : found_)
        {
            local[candidate] = 0;
        }
        std::iota(local.begin(), local.begin() + brick.own, 0);
        int next = brick.own;
        std::vector<std::uint8_t> hidden(brick.own, 0);
        const auto numberThose = [&](int begin, int end)
        {
            for (int k = std::max(begin, brick.own); k < end; ++k)
            {
                if (local[k] == 0)
                {
                    local[k] = next++;
                    brick.others.push_back(candidates_[k]);
                    hidden.push_back(0);
                }
            }
            for (const auto& [key, view] : views_)
            {
                if (key.first >= begin && key.first < end)
                {
                    local[view] = next++;
                    brick.others.push_back(candidates_[key.first]);
                    hidden.push_back(static_cast<std::uint8_t>(key.second));
                }
            }
        };
        numberThose(0, firstWall_);
        brick.liquid = next;
        numberThose(firstWall_, static_cast<int>(candidates_.size()));
        if (!views_.empty())
        {
            brick.hidden = std::move(hidden);
        }
        brick.entries.resize(found_.size());
        std::transform(
            found_.begin(), found_.end(), brick.entries.begin(),
            [&](int candidate) { return static_cast<std::uint16_t>(local[candidate]); }
        );
        return next <= std::numeric_limits<std::uint16_t>::max();
    }

    const Clusters& liquid_;
    const Clusters& walls_;
    const ListedPoints<dim>& liquidPoints_;
    const ListedPoints<dim>& wallPoints_;
    float reach_;
    double farthest_;
    int firstWall_ = 0;
    int firstWallParticle_ = liquid_.firstPlace(liquid_.clusters());

    std::vector<int> candidates_, nearLiquid_, nearWalls_, found_, local_;
    std::array<std::vector<float>, dim> low_, high_;
    std::vector<float> skin_;
    std::map<std::pair<int, unsigned>, int> views_; // of candidates some of whose lanes are hidden
};

} // namespace slosh
