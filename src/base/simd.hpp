// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/scalarMath.hpp"

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <experimental/simd>
#include <utility>

/// Vectors as scalar types of base/scalarMath.hpp, and how their lanes are loaded.
namespace slosh
{

template <class T>
using Simd = std::experimental::native_simd<T>;

template <class T, class Abi>
struct ScalarTraits<std::experimental::simd<T, Abi>>
{
    using S = std::experimental::simd<T, Abi>;
    using Real = T;
    using Integer = std::experimental::rebind_simd_t<std::conditional_t<sizeof(T) == 4, std::int32_t, std::int64_t>, S>;
    static constexpr int lanes = static_cast<int>(S::size());

    static S select(const typename S::mask_type& condition, S a, const S& b)
    {
        std::experimental::where(!condition, a) = b;
        return a;
    }
    static S whereBelow(int bound, const std::uint16_t* index, const S& x)
    {
        // By numbers, not by the sign of integers: clang 14 shifts 64-bit ones wrongly where the processor cannot.
        const S number(index, std::experimental::element_aligned);
        S y = x;
        std::experimental::where(number >= static_cast<T>(bound), y) = 0;
        return y;
    }
    static S positivePart(const S& x) { return std::experimental::max(x, S(0)); }
    static S atMost(double bound, const S& x) { return std::experimental::min(x, S(static_cast<T>(bound))); }
    static S squareRoot(const S& x) { return std::experimental::sqrt(x); }
    static T laneSum(const S& x) { return std::experimental::reduce(x); }
    static S fromInteger(const Integer& x) { return std::experimental::static_simd_cast<S>(x); }

    /// 2^n 2^f with f in [-1/2, 1/2] and the Taylor polynomial of 2^f = e^(f ln 2), of degree 11 in double (relative
    /// error < 1e-13). In float, degree 6 < 2e-7: the term y^7/7! is not cut off but replaced by the polynomial of
    /// degree 5 nearest to it on |y| <= a = ln 2/2, which is y^7 - a^7 T_7(y/a)/64 with Chebyshev's T_7(s) = 64 s^7 -
    /// 112 s^5 + 56 s^3 - 7 s (Lanczos' economisation).
    static S expOfMinus(const S& x)
    {
        using I = Integer;
        constexpr int mantissaBits = sizeof(T) == 4 ? 23 : 52;
        constexpr int degree = sizeof(T) == 4 ? 6 : 11;
        constexpr T log2e = T(1.4426950408889634074);

        const S t = x * (-log2e);
        // Adding 1.5 * 2^mantissaBits rounds to the nearest integer and leaves it in the lowest bits.
        constexpr T shift = T(1.5) * static_cast<T>(std::int64_t(1) << mantissaBits);
        const S shifted = t + shift;
        const S n = shifted - shift;
        // f ln 2, with the product's rounding kept out of the large part of t.
        constexpr T ln2High = sizeof(T) == 4 ? T(0.693359375) : T(0.693147180369123816490);
        constexpr T ln2Low = sizeof(T) == 4 ? T(-2.12194440e-4) : T(1.90821492927058770002e-10);
        const S y = -x - n * ln2High - n * ln2Low;

        T inverseFactorial[degree + 1];
        inverseFactorial[0] = 1;
        for (int k = 1; k <= degree; ++k)
        {
            inverseFactorial[k] = inverseFactorial[k - 1] / T(k);
        }
        if constexpr (degree == 6)
        {
            constexpr T a2 = T(0.12011325347955036); // (ln 2/2)^2
            const T next = inverseFactorial[6] / 7 / 64;
            inverseFactorial[5] += 112 * a2 * next;
            inverseFactorial[3] -= 56 * a2 * a2 * next;
            inverseFactorial[1] += 7 * a2 * a2 * a2 * next;
        }
        S sum;
        if constexpr (degree == 6) // Estrin's scheme: half of Horner's chain of dependent operations
        {
            const T* c = inverseFactorial;
            const S y2 = y * y;
            const S low = S(c[0]) + c[1] * y, middle = S(c[2]) + c[3] * y, high = (S(c[4]) + c[5] * y) + c[6] * y2;
            sum = low + y2 * (middle + y2 * high);
        }
        else
        {
            sum = inverseFactorial[degree];
            for (int k = degree - 1; k >= 0; --k)
            {
                sum = sum * y + inverseFactorial[k];
            }
        }
        const I exponent = std::bit_cast<I>(shifted) << mantissaBits;
        return std::bit_cast<S>(std::bit_cast<I>(sum) + exponent);
    }
};

namespace detail
{

template <class T, int W>
using Lanes [[gnu::vector_size(sizeof(T) * W)]] = T;

/// Loads n values of each of the records index[0], index[n], index[2 n] ... index[W - n] into adjacent lanes.
template <class T, int W, int n>
inline Lanes<T, W> loadPieces(const T* records, const std::uint16_t* index)
{
    if constexpr (W == n)
    {
        Lanes<T, n> piece;
        std::memcpy(&piece, records + 8 * static_cast<std::ptrdiff_t>(index[0]), sizeof piece);
        return piece;
    }
    else
    {
        const auto first = loadPieces<T, W / 2, n>(records, index);
        const auto second = loadPieces<T, W / 2, n>(records, index + W / 2);
        return [&]<int... lane>(std::integer_sequence<int, lane...>)
        {
            return __builtin_shufflevector(first, second, lane...);
        }
        (std::make_integer_sequence<int, W>());
    }
}

/// a0 b0 a1 b1 ... of the lower (half = 0) or upper halves of each run of n lanes: processors have it as one
/// instruction where n values fill 16 bytes.
template <int n, int half, class V, int... lane>
inline V interleave(const V& a, const V& b, std::integer_sequence<int, lane...>)
{
    constexpr int W = sizeof...(lane);
    return __builtin_shufflevector(a, b, (lane / n * n + half * n / 2 + lane % n / 2 + (lane % 2 == 0 ? 0 : W))...);
}

/// Transposes each of the W/n adjacent n x n blocks in n vectors of W lanes.
template <int W, int n, class V>
inline void transpose(V* rows)
{
    constexpr auto lanes = std::make_integer_sequence<int, W>();
    if constexpr (n == 2)
    {
        const V a = rows[0], b = rows[1];
        rows[0] = interleave<2, 0>(a, b, lanes);
        rows[1] = interleave<2, 1>(a, b, lanes);
    }
    else
    {
        static_assert(n == 4);
        const V even0 = interleave<4, 0>(rows[0], rows[2], lanes), even1 = interleave<4, 1>(rows[0], rows[2], lanes);
        const V odd0 = interleave<4, 0>(rows[1], rows[3], lanes), odd1 = interleave<4, 1>(rows[1], rows[3], lanes);
        rows[0] = interleave<4, 0>(even0, odd0, lanes);
        rows[1] = interleave<4, 1>(even0, odd0, lanes);
        rows[2] = interleave<4, 0>(even1, odd1, lanes);
        rows[3] = interleave<4, 1>(even1, odd1, lanes);
    }
}

} // namespace detail

/// Loads the records index[0 .. lanes-1], eight values each, and turns them into eight vectors: out[c][lane] =
/// records[8 index[lane] + c]. Loads of 16 bytes and a transposition in registers cost a third of eight gathers.
template <class S>
inline std::array<S, 8> loadRecords(const RealOf<S>* records, const std::uint16_t* index)
{
    using T = RealOf<S>;
    constexpr int W = lanesOf<S>;
    std::array<S, 8> out;
    if constexpr (W == 1)
    {
        for (int c = 0; c < 8; ++c)
        {
            out[c] = records[8 * static_cast<std::ptrdiff_t>(index[0]) + c];
        }
    }
    else
    {
        constexpr int n = 16 / sizeof(T); // values in 16 bytes
        using V = detail::Lanes<T, W>;
        static_assert(sizeof(V) == sizeof(S) && W % n == 0);
        for (int c = 0; c < 8; c += n)
        {
            V rows[n];
            for (int i = 0; i < n; ++i)
            {
                rows[i] = detail::loadPieces<T, W, n>(records + c, index + i);
            }
            detail::transpose<W, n>(rows);
            for (int i = 0; i < n; ++i)
            {
                out[c + i] = std::bit_cast<S>(rows[i]);
            }
        }
    }
    return out;
}

} // namespace slosh
