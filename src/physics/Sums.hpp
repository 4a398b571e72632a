// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/scalarMath.hpp"

#include <cstddef>

namespace slosh
{

/// Where terms add what a pair gives: the sums of a particle a, or of its neighbours b, lane by lane, `numbers` in all,
/// which follow each other in the order of the terms. from(k): those from number k on.

/// Of a, in registers while its row is walked; the lanes are added afterwards.
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

/// Of the particles of a cluster of `width`, in memory: number k of all, then number k + 1 of all.
template <class S, int width>
struct SumsOfCluster
{
    RealOf<S>* sum;

    SumsOfCluster from(std::size_t k) const { return {sum + k * width}; }
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
    RealOf<S>* at(std::size_t k) const { return sum + k * width; }
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
