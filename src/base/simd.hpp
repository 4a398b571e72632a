// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/scalarMath.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <experimental/simd>
#include <utility>

#ifdef __AVX__
#include <immintrin.h>
#endif

/// Vectors as scalar types of base/scalarMath.hpp.
namespace slosh
{

/// 8 floats or 4 doubles, whatever the processor's registers hold, so that sums over lanes have one order everywhere.
template <class T>
using Simd = std::experimental::simd<T, std::experimental::simd_abi::deduce_t<T, 32 / sizeof(T)>>;

/// What pair loops compute with: where registers hold 512 bits, two rows of these.
#if defined(__AVX512F__) && defined(__AVX512DQ__)
inline constexpr int rowsAtATime = 2;
#else
inline constexpr int rowsAtATime = 1;
#endif
template <class T>
using SimdOfRows = std::experimental::simd<T, std::experimental::simd_abi::deduce_t<T, rowsAtATime * 32 / sizeof(T)>>;

namespace detail
{

template <class T, int W>
using Lanes [[gnu::vector_size(sizeof(T) * W)]] = T;

/// Lane k: the sum over the lanes of rows[k]. Neighbouring lanes are added first, within each 16 bytes, as processors
/// do it without moving between halves; then the halves.
template <class T>
[[gnu::always_inline]] inline Lanes<T, 8> rowSumsOf8(const Lanes<T, 8>* rows)
{
    using V = Lanes<T, 8>;
    const auto pairwise = [](const V& a, const V& b) __attribute__((always_inline))
    {
        return __builtin_shufflevector(a, b, 0, 2, 8, 10, 4, 6, 12, 14) +
               __builtin_shufflevector(a, b, 1, 3, 9, 11, 5, 7, 13, 15);
    };
    const V low = pairwise(pairwise(rows[0], rows[1]), pairwise(rows[2], rows[3]));
    const V high = pairwise(pairwise(rows[4], rows[5]), pairwise(rows[6], rows[7]));
    return __builtin_shufflevector(low, high, 0, 1, 2, 3, 8, 9, 10, 11) +
           __builtin_shufflevector(low, high, 4, 5, 6, 7, 12, 13, 14, 15);
}

template <class T>
[[gnu::always_inline]] inline Lanes<T, 4> rowSumsOf4(const Lanes<T, 4>* rows)
{
    using V = Lanes<T, 4>;
    const auto pairwise = [](const V& a, const V& b) __attribute__((always_inline))
    {
        return __builtin_shufflevector(a, b, 0, 4, 2, 6) + __builtin_shufflevector(a, b, 1, 5, 3, 7);
    };
    const V low = pairwise(rows[0], rows[1]), high = pairwise(rows[2], rows[3]);
    return __builtin_shufflevector(low, high, 0, 1, 4, 5) + __builtin_shufflevector(low, high, 2, 3, 6, 7);
}

} // namespace detail

template <class T, class Abi>
struct ScalarTraits<std::experimental::simd<T, Abi>>
{
    using S = std::experimental::simd<T, Abi>;
    using Real = T;
    using Integer = std::experimental::rebind_simd_t<std::conditional_t<sizeof(T) == 4, std::int32_t, std::int64_t>, S>;
    static constexpr int lanes = static_cast<int>(S::size());
    static constexpr int rows = sizeof(S) == 64 ? 2 : 1;
    using Row = Simd<T>;

    // Always inlined: gcc 12 leaves some of these as calls in the loops, which costs all that registers hold.

    [[gnu::always_inline]] static S broadcast(T x)
    {
        return [x]<int... lane>(std::integer_sequence<int, lane...>) __attribute__((always_inline))
        {
            return withBitsOf<S>(detail::Lanes<T, lanes>{((void)lane, x)...});
        }
        (std::make_integer_sequence<int, lanes>());
    }
    [[gnu::always_inline]] static S select(const typename S::mask_type& condition, const S& a, S b)
    {
        std::experimental::where(condition, b) = a;
        return b;
    }
    [[gnu::always_inline]] static S multiplyAdd(const S& a, const S& b, const S& c)
    {
#ifdef __AVX512F__
        if constexpr (rows == 2 && sizeof(T) == 4)
        {
            return withBitsOf<S>(_mm512_fmadd_ps(withBitsOf<__m512>(a), withBitsOf<__m512>(b), withBitsOf<__m512>(c)));
        }
        else if constexpr (rows == 2)
        {
            return withBitsOf<S>(_mm512_fmadd_pd(withBitsOf<__m512d>(a), withBitsOf<__m512d>(b), withBitsOf<__m512d>(c))
            );
        }
        else
#endif
#if defined(__FMA__)
            if constexpr (sizeof(T) == 4)
        {
            return withBitsOf<S>(_mm256_fmadd_ps(withBitsOf<__m256>(a), withBitsOf<__m256>(b), withBitsOf<__m256>(c)));
        }
        else
        {
            return withBitsOf<S>(_mm256_fmadd_pd(withBitsOf<__m256d>(a), withBitsOf<__m256d>(b), withBitsOf<__m256d>(c))
            );
        }
#elif defined(__FP_FAST_FMA)
        return S([&](auto lane) { return std::fma(T(a[lane]), T(b[lane]), T(c[lane])); });
#else
        return a * b + c;
#endif
    }
    [[gnu::always_inline]] static unsigned whereLess(const S& a, const S& b)
    {
        static_assert(rows == 1);
#ifdef __AVX__
        if constexpr (sizeof(T) == 4)
        {
            return static_cast<unsigned>(
                _mm256_movemask_ps(_mm256_cmp_ps(withBitsOf<__m256>(a), withBitsOf<__m256>(b), _CMP_LT_OQ))
            );
        }
        else
        {
            return static_cast<unsigned>(
                _mm256_movemask_pd(_mm256_cmp_pd(withBitsOf<__m256d>(a), withBitsOf<__m256d>(b), _CMP_LT_OQ))
            );
        }
#else
        unsigned bits = 0;
        for (unsigned lane = 0; lane < lanes; ++lane)
        {
            bits |= (T(a[lane]) < T(b[lane]) ? 1U : 0U) << lane;
        }
        return bits;
#endif
    }
    [[gnu::always_inline]] static S positivePart(const S& x)
    {
        return std::experimental::max(x, broadcast(T(0)));
    }
    [[gnu::always_inline]] static S atMost(double bound, const S& x)
    {
        return std::experimental::min(x, broadcast(static_cast<T>(bound)));
    }
    [[gnu::always_inline]] static S squareRoot(const S& x)
    {
        return std::experimental::sqrt(x);
    }
    [[gnu::always_inline]] static S rowSums(const S* rows)
    {
        using V = detail::Lanes<T, lanes>;
        V in[lanes];
        for (int k = 0; k < lanes; ++k)
        {
            in[k] = withBitsOf<V>(rows[k]);
        }
        if constexpr (lanes == 8)
        {
            return withBitsOf<S>(detail::rowSumsOf8<T>(in));
        }
        else
        {
            return withBitsOf<S>(detail::rowSumsOf4<T>(in));
        }
    }
    [[gnu::always_inline]] static S load(const T* values)
    {
        return S(values, std::experimental::vector_aligned);
    }
#ifdef __AVX512DQ__
    [[gnu::always_inline]] static S loadInRows(const T* values)
    {
        if constexpr (sizeof(T) == 4)
        {
            return withBitsOf<S>(_mm512_broadcast_f32x8(_mm256_load_ps(values)));
        }
        else
        {
            return withBitsOf<S>(_mm512_broadcast_f64x4(_mm256_load_pd(values)));
        }
    }
    [[gnu::always_inline]] static S ofRows(const Row& first, const Row& second)
    {
        if constexpr (sizeof(T) == 4)
        {
            return withBitsOf<S>(
                _mm512_insertf32x8(_mm512_castps256_ps512(withBitsOf<__m256>(first)), withBitsOf<__m256>(second), 1)
            );
        }
        else
        {
            return withBitsOf<S>(
                _mm512_insertf64x4(_mm512_castpd256_pd512(withBitsOf<__m256d>(first)), withBitsOf<__m256d>(second), 1)
            );
        }
    }
    template <int k>
    [[gnu::always_inline]] static Row row(const S& x)
    {
        if constexpr (sizeof(T) == 4)
        {
            return withBitsOf<Row>(_mm512_extractf32x8_ps(withBitsOf<__m512>(x), k));
        }
        else
        {
            return withBitsOf<Row>(_mm512_extractf64x4_pd(withBitsOf<__m512d>(x), k));
        }
    }
#endif
    [[gnu::always_inline]] static void store(const S& x, T* values)
    {
        x.copy_to(values, std::experimental::vector_aligned);
    }
    [[gnu::always_inline]] static S fromInteger(const Integer& x)
    {
        return std::experimental::static_simd_cast<S>(x);
    }

    /// In float (e^(-x/16))^16, with the polynomial of degree 6 that agrees with e^-u at the seven Chebyshev nodes of
    /// [0, 9/16]: 9e-9 off, and sixteen times the rounding of a float, 2e-6. In double 2^n 2^f with f in [-1/2, 1/2]
    /// and the Taylor polynomial of 2^f = e^(f ln 2) of degree 11 (relative error < 1e-13).
    [[gnu::always_inline]] static S expOfMinus(const S& x)
    {
        if constexpr (sizeof(T) == 4)
        {
            S sum = broadcast(T(coefficients[6]));
            for (int k = 5; k >= 0; --k)
            {
                sum = multiplyAdd(sum, x, broadcast(T(coefficients[k])));
            }
            for (int squarings = 0; squarings < 4; ++squarings)
            {
                sum = sum * sum;
            }
            return sum;
        }
        else
        {
            constexpr int mantissaBits = 52, degree = 11;
            const S inRange = atMost(80, x);                 // beyond it no exponent
            const S t = inRange * T(-1.4426950408889634074); // log2 e
            // Adding 1.5 * 2^mantissaBits rounds to the nearest integer and leaves it in the lowest bits.
            constexpr T shift = T(1.5) * static_cast<T>(std::int64_t(1) << mantissaBits);
            const S shifted = t + shift;
            const S n = shifted - shift;
            // f ln 2, with the product's rounding kept out of the large part of t.
            const S y = multiplyAdd(
                n, broadcast(T(-1.90821492927058770002e-10)),
                multiplyAdd(n, broadcast(T(-0.693147180369123816490)), -inRange)
            );
            T inverseFactorial[degree + 1];
            inverseFactorial[0] = 1;
            for (int k = 1; k <= degree; ++k)
            {
                inverseFactorial[k] = inverseFactorial[k - 1] / T(k);
            }
            S sum = broadcast(inverseFactorial[degree]);
            for (int k = degree - 1; k >= 0; --k)
            {
                sum = multiplyAdd(sum, y, broadcast(inverseFactorial[k]));
            }
            const Integer exponent = withBitsOf<Integer>(shifted) << mantissaBits;
            return withBitsOf<S>(withBitsOf<Integer>(sum) + exponent);
        }
    }

private:
    /// Of x^k, k = 0 ... 6: those of u^k over 16^k.
    static constexpr std::array<double, 7> coefficients = {
        0.99999999966177888,    -0.062499996314432836,   0.0019531184231237795, -4.0685686536118232e-05,
        6.3436179362444298e-07, -7.7100984015677066e-09, 6.264345176396129e-11};
};

} // namespace slosh
