// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <type_traits>

/// Formulas are written once, generically in a scalar type S: float, double (the readable reference) or a vector of
/// them (base/simd.hpp, the production loops). What differs between them is here.
namespace slosh
{

/// The bits of `from` as a To of the same size. std::bit_cast does not take vectors of several registers, which
/// libstdc++ has not made trivially copyable; they are.
template <class To, class From>
[[gnu::always_inline]] inline To withBitsOf(const From& from)
{
    static_assert(sizeof(To) == sizeof(From));
    if constexpr (std::is_trivially_copyable_v<To> && std::is_trivially_copyable_v<From>)
    {
        return std::bit_cast<To>(from);
    }
    else
    {
        To to;
        std::memcpy(static_cast<void*>(&to), static_cast<const void*>(&from), sizeof to);
        return to;
    }
}

/// Of a plain number; base/simd.hpp has it for vectors.
template <class S>
struct ScalarTraits
{
    static_assert(std::is_floating_point_v<S>);
    using Real = S;
    using Integer = std::conditional_t<sizeof(S) == 4, std::int32_t, std::int64_t>;
    static constexpr int lanes = 1, rows = 1;
    using Row = S;

    static S broadcast(S x) { return x; }
    static S select(bool condition, S a, S b) { return condition ? a : b; }
    static S multiplyAdd(S a, S b, S c)
    {
#if defined(__FMA__) || defined(__FP_FAST_FMA)
        return std::fma(a, b, c);
#else
        return a * b + c;
#endif
    }
    static unsigned whereLess(S a, S b)
    {
        return a < b ? 1 : 0;
    }
    static S positivePart(S x)
    {
        return x > 0 ? x : 0;
    }
    static S atMost(double bound, S x)
    {
        return x < static_cast<S>(bound) ? x : static_cast<S>(bound);
    }
    static S squareRoot(S x)
    {
        return std::sqrt(x);
    }
    static S rowSums(const S* rows)
    {
        return rows[0];
    }
    static S load(const S* values)
    {
        return *values;
    }
    static void store(S x, S* values)
    {
        *values = x;
    }
    static S expOfMinus(S x)
    {
        return std::exp(-x);
    }
    static S fromInteger(Integer x)
    {
        return static_cast<S>(x);
    }
};

template <class S>
using RealOf = typename ScalarTraits<S>::Real;

template <class S>
inline constexpr int lanesOf = ScalarTraits<S>::lanes;

/// A vector may stand for several rows of as many lanes each; one row is a RowOf<S>.
template <class S>
inline constexpr int rowsOf = ScalarTraits<S>::rows;
template <class S>
using RowOf = typename ScalarTraits<S>::Row;
/// A number of each row.
template <class S>
using PerRow = std::array<RealOf<S>, rowsOf<S>>;

/// x in every lane.
template <class S>
[[gnu::always_inline]] inline S broadcast(RealOf<S> x)
{
    return ScalarTraits<S>::broadcast(x);
}

/// In every lane of a row its x.
template <class S>
[[gnu::always_inline]] inline S broadcast(const PerRow<S>& x)
{
    if constexpr (rowsOf<S> == 1)
    {
        return ScalarTraits<S>::broadcast(x[0]);
    }
    else
    {
        return ScalarTraits<S>::ofRows(broadcast<RowOf<S>>(x[0]), broadcast<RowOf<S>>(x[1]));
    }
}

/// Row k of x.
template <int k, class S>
[[gnu::always_inline]] inline RowOf<S> row(const S& x)
{
    if constexpr (rowsOf<S> == 1)
    {
        return x;
    }
    else
    {
        return ScalarTraits<S>::template row<k>(x);
    }
}

/// condition ? a : b, lane by lane.
template <class Condition, class S>
[[gnu::always_inline]] inline S select(const Condition& condition, const S& a, const S& b)
{
    return ScalarTraits<S>::select(condition, a, b);
}

/// a b + c, rounded once where the processor can: the same number at every level of the instruction set that has it.
/// Compilers do not fuse by themselves (-ffp-contract=off), as each would choose other operations.
template <class S>
[[gnu::always_inline]] inline S multiplyAdd(const S& a, const S& b, const S& c)
{
    return ScalarTraits<S>::multiplyAdd(a, b, c);
}

/// c - a b, rounded once.
template <class S>
[[gnu::always_inline]] inline S subtractProduct(const S& a, const S& b, const S& c)
{
    return ScalarTraits<S>::multiplyAdd(-a, b, c);
}

/// The lanes in which a < b, by bits.
template <class S>
[[gnu::always_inline]] inline unsigned whereLess(const S& a, const S& b)
{
    return ScalarTraits<S>::whereLess(a, b);
}

/// max(x, 0)
template <class S>
[[gnu::always_inline]] inline S positivePart(const S& x)
{
    return ScalarTraits<S>::positivePart(x);
}

/// min(x, bound)
template <class S>
[[gnu::always_inline]] inline S atMost(double bound, const S& x)
{
    return ScalarTraits<S>::atMost(bound, x);
}

template <class S>
[[gnu::always_inline]] inline S squareRoot(const S& x)
{
    return ScalarTraits<S>::squareRoot(x);
}

/// In lane k the sum over the lanes of rows[k], of as many rows as S has lanes; always in the same order.
template <class S>
[[gnu::always_inline]] inline S rowSums(const S* rows)
{
    return ScalarTraits<S>::rowSums(rows);
}

/// As many adjacent values as S has lanes, aligned for S.
template <class S>
[[gnu::always_inline]] inline S load(const RealOf<S>* values)
{
    return ScalarTraits<S>::load(values);
}

/// In every row as many adjacent values as it has lanes, aligned for it.
template <class S>
[[gnu::always_inline]] inline S loadInRows(const RealOf<S>* values)
{
    if constexpr (rowsOf<S> == 1)
    {
        return load<S>(values);
    }
    else
    {
        return ScalarTraits<S>::loadInRows(values);
    }
}

template <class S>
[[gnu::always_inline]] inline void store(const S& x, RealOf<S>* values)
{
    ScalarTraits<S>::store(x, values);
}

/// f of each lane.
template <class S, class F>
S ofEach(const S& x, const F& f)
{
    alignas(64) RealOf<S> values[lanesOf<S>];
    store(x, values);
    for (RealOf<S>& value : values)
    {
        value = f(value);
    }
    return load<S>(values);
}

/// e^-x for 0 <= x <= 9: what kernels ask for; beyond it any value, infinite or not, but no NaN.
template <class S>
[[gnu::always_inline]] inline S expOfMinus(const S& x)
{
    return ScalarTraits<S>::expOfMinus(x);
}

} // namespace slosh
