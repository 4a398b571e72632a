// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/scalarMath.hpp"
#include "neighbours/Clusters.hpp"

#include <cstddef>

namespace slosh
{

/// Where terms add what a pair gives: the sums of a particle a, or of its neighbours b, lane by lane, `numbers` in all,
/// which follow each other in the order of the terms. from(k): those from number k on.

/// Of a, in registers while its row is walked; the lanes are added afterwards. Where S stands for several rows, of
/// their particles.
template <class S>
struct SumsOfRow
{
    S* sum;

    SumsOfRow from(std::size_t k) const { return {sum + k}; }
    [[gnu::always_inline]] void add(std::size_t k, const S& x) const { sum[k] += x; }
    [[gnu::always_inline]] void addProduct(std::size_t k, const S& x, const S& y) const
    {
        sum[k] = multiplyAdd(x, y, sum[k]);
    }
    [[gnu::always_inline]] void subtractProduct(std::size_t k, const S& x, const S& y) const
    {
        sum[k] = slosh::subtractProduct(x, y, sum[k]);
    }
};

/// Of the particles b of a cluster, in memory. There are two partial sums: of the particles a at even places of their
/// clusters, and of those at odd places. One a at a time or two neighbouring ones in one vector therefore give the same
/// order of summation. Number k of all, then number k + 1 of all.
template <class S>
struct SumsOfCluster
{
    static constexpr std::size_t perNumber = std::size_t{2} * clusterSize;
    static constexpr std::size_t lanesOfRow = lanesOf<S> / rowsOf<S>;

    RealOf<S>* sum;

    /// `sums` of a cluster, for its particles from `lane` on and a at `place`.
    static SumsOfCluster of(RealOf<S>* sums, int lane, int place)
    {
        return {sums + 2 * lane + (rowsOf<S> == 1 ? place % 2 * lanesOfRow : 0)};
    }
    /// Of its particles from `lane` on, both parts together.
    static RowOf<S> total(const RealOf<S>* sums, int lane)
    {
        const RealOf<S>* const even = sums + 2 * lane;
        return load<RowOf<S>>(even) + load<RowOf<S>>(even + lanesOfRow);
    }

    SumsOfCluster from(std::size_t k) const { return {sum + k * perNumber}; }
    [[gnu::always_inline]] void add(std::size_t k, const S& x) const { store(load<S>(at(k)) + x, at(k)); }
    [[gnu::always_inline]] void addProduct(std::size_t k, const S& x, const S& y) const
    {
        store(multiplyAdd(x, y, load<S>(at(k))), at(k));
    }
    [[gnu::always_inline]] void subtractProduct(std::size_t k, const S& x, const S& y) const
    {
        store(slosh::subtractProduct(x, y, load<S>(at(k))), at(k));
    }

private:
    RealOf<S>* at(std::size_t k) const { return sum + k * perNumber; }
};

/// Of those whose sums nobody wants here.
struct NoSums
{
    NoSums from(std::size_t) const { return {}; }
    template <class S>
    [[gnu::always_inline]] void add(std::size_t, const S&) const
    {
    }
    template <class S>
    [[gnu::always_inline]] void addProduct(std::size_t, const S&, const S&) const
    {
    }
    template <class S>
    [[gnu::always_inline]] void subtractProduct(std::size_t, const S&, const S&) const
    {
    }
};

} // namespace slosh
