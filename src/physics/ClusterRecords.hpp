// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Vec.hpp"
#include "base/alignedVector.hpp"
#include "base/boundingBox.hpp"
#include "base/parallel.hpp"
#include "neighbours/ClusterLists.hpp"
#include "particles/Particles.hpp"
#include "physics/Pair.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

namespace slosh
{

/// One of each particle of a cluster, aligned for vectors.
template <class T>
struct alignas(64) OfCluster : std::array<T, clusterSize>
{
};

/// What pairs need of the particles, cluster by cluster: number k of the eight, then number k + 1 of the eight, in the
/// order of Neighbour's members.
///
/// Positions: in double, (x - origin)/h. In float they are 32-bit integers in units of 2^-30 of the packed box, so that
/// a difference of two is exact and a tank of 4096 spacings is resolved to 4e-6 dx, where a float would leave 2e-4 dx.
/// Where a cluster has fewer than eight particles the others are padding: farther than any support from all, P = 0, v =
/// 0.
template <int dim, class Real>
class ClusterRecords
{
public:
    static constexpr std::size_t numbers = Neighbour<dim, Real>::numbers;
    static constexpr std::size_t perCluster = numbers * clusterSize;

    /// directions: the components of Vec that are not empty.
    ClusterRecords(const std::array<int, 3>& directions, double smoothingLength, double supportRadius)
        : directions_(directions), h_(smoothingLength), supportRadius_(supportRadius)
    {
    }

    /// Chooses the box that positions are packed in: all of them and `margin` around, for as long as none moves
    /// farther. Positions of walls are packed.
    void listBuilt(const Particles& particles, const ClusterLists& lists, double margin)
    {
        const BoundingBox box = boundingBox(particles.r);
        origin_ = box.min().array() - margin;
        span_ = std::max((box.max() - box.min()).maxCoeff() + 2 * margin, 8 * supportRadius_);
        unitsPerMetre_ = unitsAcross / span_;
        unit_ = sizeof(Real) == 4 ? static_cast<Real>(span_ / (unitsAcross * h_)) : Real(1);
        farAway_.assign(perCluster, Real(0));
        packPositions(farAway_.data(), farAwayPositions());
        std::fill_n(farAway_.end() - clusterSize, clusterSize, Real(1));
        liquid_.resize(perCluster * lists.liquid().clusters());
        walls_.assign(perCluster * lists.walls().clusters(), Real(0));
        packWallPositions(particles, lists);
    }

    void packLiquid(const Particles& particles, const Clusters& clusters, std::ptrdiff_t cluster)
    {
        const int first = clusters.firstPlace(cluster), size = clusters.pointsIn(cluster);
        Real* const record = &liquid_[perCluster * cluster];
        auto x = farAwayPositions();
        std::array<OfCluster<double>, dim> v{};
        OfCluster<double> rho, p{};
        rho.fill(1);
        for (int lane = 0; lane < size; ++lane)
        {
            const int i = clusters.point(first + lane);
            for (std::size_t d = 0; d < dim; ++d)
            {
                x[d][lane] = particles.r[i][directions_[d]];
                v[d][lane] = particles.v[i][directions_[d]];
            }
            rho[lane] = particles.rho[i];
            p[lane] = particles.p[i];
        }
        packPositions(record, x);
        packFlow(record, v, p, rho);
    }
    void packWallPositions(const Particles& particles, const ClusterLists& lists)
    {
        const Clusters& clusters = lists.walls();
        parallelFor(
            static_cast<std::ptrdiff_t>(lists.wallsInReach().size()),
            [&](std::ptrdiff_t k)
            {
                const int c = lists.wallsInReach()[k];
                auto x = farAwayPositions();
                for (int lane = 0; lane < clusters.pointsIn(c); ++lane)
                {
                    const int w = clusters.point(clusters.firstPlace(c) + lane);
                    for (std::size_t d = 0; d < dim; ++d)
                    {
                        x[d][lane] = particles.r[particles.nFluid + w][directions_[d]];
                    }
                }
                packPositions(&walls_[perCluster * c], x);
            }
        );
    }
    /// The flow that a cluster of walls shows; of lanes without a particle none.
    void packWalls(
        std::ptrdiff_t cluster, const std::array<OfCluster<double>, dim>& v, const OfCluster<double>& p,
        const OfCluster<double>& rho
    )
    {
        packFlow(&walls_[perCluster * cluster], v, p, rho);
    }

    /// The records of a brick's clusters by their local numbers; without those of other liquid if `wallsAlone`.
    void gather(const ClusterLists::Brick& brick, bool wallsAlone, Real* local) const
    {
        const Real* const own = &liquid_[perCluster * brick.firstCluster];
        std::copy(own, own + perCluster * brick.own, local);
        for (int k = wallsAlone ? brick.liquid : brick.own; k < brick.size(); ++k)
        {
            const Real* const from = &(k < brick.liquid ? liquid_ : walls_)[perCluster * brick.cluster(k)];
            std::copy(from, from + perCluster, local + perCluster * k);
        }
        for (std::size_t k = 0; k < brick.hidden.size(); ++k)
        {
            for (unsigned lane = 0; lane < clusterSize; ++lane)
            {
                if (((brick.hidden[k] >> lane) & 1U) != 0)
                {
                    for (std::size_t d = 0; d < dim; ++d)
                    {
                        local[perCluster * k + clusterSize * d + lane] = packed(-span_);
                    }
                }
            }
        }
    }

    /// A cluster's of walls.
    const Real* ofWalls(std::ptrdiff_t cluster) const { return &walls_[perCluster * cluster]; }
    /// A cluster out of reach of all.
    const Real* farAway() const { return farAway_.data(); }
    /// Multiplies a difference of positions (integers in float) into units of h.
    Real toSmoothingLengths() const { return unit_; }
    std::size_t bytes() const { return (liquid_.capacity() + walls_.capacity()) * sizeof(Real); }

private:
    static constexpr double unitsAcross = 1073741823.0; // 2^30 - 1: with padding at -(2^30 - 1) no difference overflows

    using Columns = std::array<OfCluster<double>, dim>;

    /// Positions out of reach of all that is packed.
    Columns farAwayPositions() const
    {
        Columns x;
        for (std::size_t d = 0; d < dim; ++d)
        {
            x[d].fill(origin_[directions_[d]] - span_);
        }
        return x;
    }

    Real packed(double fromOrigin) const
    {
        if constexpr (sizeof(Real) == 4)
        {
            // A coordinate that is out of range or NaN (a run that diverges) is clamped.
            const double units = std::max(-unitsAcross, std::min(unitsAcross, fromOrigin * unitsPerMetre_));
            return std::bit_cast<float>(static_cast<std::int32_t>(units));
        }
        else
        {
            return fromOrigin / h_;
        }
    }

    // All lanes at once: compilers make vectors of these.

    void packPositions(Real* record, const Columns& x) const
    {
        for (std::size_t d = 0; d < dim; ++d)
        {
            const double origin = origin_[directions_[d]];
            for (int lane = 0; lane < clusterSize; ++lane)
            {
                record[clusterSize * d + lane] = packed(x[d][lane] - origin);
            }
        }
    }

    static void packFlow(Real* record, const Columns& v, const OfCluster<double>& p, const OfCluster<double>& rho)
    {
        for (std::size_t d = 0; d < dim; ++d)
        {
            for (int lane = 0; lane < clusterSize; ++lane)
            {
                record[clusterSize * (dim + d) + lane] = static_cast<Real>(v[d][lane]);
            }
        }
        for (int lane = 0; lane < clusterSize; ++lane)
        {
            const double s = 1 / rho[lane];
            record[clusterSize * (2 * dim) + lane] = static_cast<Real>(p[lane] * s * s);
            record[clusterSize * (2 * dim + 1) + lane] = static_cast<Real>(s);
        }
    }

    std::array<int, 3> directions_;
    double h_;
    double supportRadius_;
    Vec origin_ = Vec::Zero();
    double span_ = 1, unitsPerMetre_ = 1;
    Real unit_ = 1;
    AlignedVector<Real> liquid_, walls_, farAway_;
};

} // namespace slosh
