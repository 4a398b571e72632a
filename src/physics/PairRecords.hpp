// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Vec.hpp"
#include "base/boundingBox.hpp"
#include "neighbours/NeighbourRows.hpp"
#include "particles/Particles.hpp"
#include "physics/Pair.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <new>
#include <vector>

namespace slosh
{

/// What a pair needs of a particle, in eight adjacent values: one aligned load of 32 bytes in float, 64 in
/// double.
///
/// Positions: in double, (x - origin)/h. In float they are 32-bit integers in units of 2^-30 of the packed box, so that
/// a difference of two is exact and a tank of 4096 spacings is resolved to 4e-6 dx, where a float would leave 2e-4 dx.
/// Particle i has the record recordOf(i). Those in between, and the last, are padding: farther than any support from
/// all others, P = 0, v = 0. They fill up rows of the neighbour list.
template <class Real>
class PairRecords
{
public:
    /// directions: the components of Vec that are not empty; in 2D two of them and a third that is ignored.
    PairRecords(int dim, const std::array<int, 3>& directions, double smoothingLength, double supportRadius)
        : dim_(dim), directions_(directions), h_(smoothingLength), supportRadius_(supportRadius)
    {
    }

    /// Chooses the box that positions are packed in: all of them and `margin` around, for as long as none moves
    /// farther.
    void enclose(const Particles& particles, double margin)
    {
        firstWall_ = recordOf(particles.nFluid);
        const BoundingBox box = boundingBox(particles.r);
        origin_ = box.min().array() - margin;
        span_ = std::max((box.max() - box.min()).maxCoeff() + 2 * margin, 8 * supportRadius_);
        unit_ = sizeof(Real) == 4 ? static_cast<Real>(span_ / (unitsAcross * h_)) : Real(1);
        const std::ptrdiff_t last = recordOf(particles.size());
        values_.resize(8 * (last + 1));
        for (std::ptrdiff_t between = recordsPerStretch - 1; between < last; between += recordsPerStretch)
        {
            writePadding(between);
        }
        writePadding(last);
    }

    void packPosition(std::size_t particle, const Vec& r) { writePosition(recordOf(particle), r); }
    void packFlow(std::size_t particle, const Vec& v, double p, double rho)
    {
        writeFlow(recordOf(particle), v, p, rho);
    }

    const Real* data() const { return values_.data(); }
    const Real* of(std::ptrdiff_t particle) const { return values_.data() + 8 * recordOf(particle); }
    /// Multiplies a difference of positions (integers in float) into units of h.
    Real toSmoothingLengths() const { return unit_; }
    /// Records from this one on are of walls.
    std::ptrdiff_t firstWall() const { return firstWall_; }
    std::size_t bytes() const { return values_.capacity() * sizeof(Real); }

private:
    static constexpr double unitsAcross = 1073741823.0; // 2^30 - 1: with padding at -(2^30 - 1) no difference overflows

    void writePadding(std::ptrdiff_t record)
    {
        writePosition(record, origin_.array() - span_);
        writeFlow(record, Vec::Zero(), 0, 1);
    }

    void writePosition(std::ptrdiff_t record, const Vec& r)
    {
        Real* values = &values_[8 * record];
        for (int d = 0; d < dim_; ++d)
        {
            const int k = directions_[d];
            const double x = r[k] - origin_[k];
            if constexpr (sizeof(Real) == 4)
            {
                // A coordinate that is out of range or NaN (a run that diverges) is clamped.
                const double units = std::max(-unitsAcross, std::min(unitsAcross, x * (unitsAcross / span_)));
                values[slotX + d] = std::bit_cast<float>(static_cast<std::int32_t>(units));
            }
            else
            {
                values[slotX + d] = x / h_;
            }
        }
    }

    void writeFlow(std::ptrdiff_t record, const Vec& v, double p, double rho)
    {
        Real* values = &values_[8 * record];
        const double s = 1 / rho;
        for (int d = 0; d < dim_; ++d)
        {
            values[slotV + d] = static_cast<Real>(v[directions_[d]]);
        }
        values[slotP] = static_cast<Real>(p * s * s);
        values[slotS] = static_cast<Real>(s);
    }

    template <class T>
    struct CacheLineAllocator
    {
        using value_type = T;
        CacheLineAllocator() = default;
        template <class U>
        CacheLineAllocator(const CacheLineAllocator<U>&)
        {
        }
        T* allocate(std::size_t n) { return static_cast<T*>(::operator new(n * sizeof(T), std::align_val_t(64))); }
        void deallocate(T* p, std::size_t) { ::operator delete(p, std::align_val_t(64)); }
        bool operator==(const CacheLineAllocator&) const { return true; }
    };

    int dim_;
    std::array<int, 3> directions_;
    double h_;
    double supportRadius_;
    std::ptrdiff_t firstWall_ = 0;
    Vec origin_ = Vec::Zero();
    double span_ = 1;
    Real unit_ = 1;
    std::vector<Real, CacheLineAllocator<Real>> values_;
};

} // namespace slosh
