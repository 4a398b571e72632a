// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstdint>
#include <type_traits>

/// Formulas are written once, generically in a scalar type S: float, double (the readable reference) or a vector of
/// them (base/simd.hpp, the production loops). What differs between them is here.
namespace slosh
{

/// Of a plain number; base/simd.hpp has it for vectors.
template <class S>
struct ScalarTraits
{
    static_assert(std::is_floating_point_v<S>);
    using Real = S;
    using Integer = std::conditional_t<sizeof(S) == 4, std::int32_t, std::int64_t>;
    static constexpr int lanes = 1;

    static S select(bool condition, S a, S b) { return condition ? a : b; }
    static S whereBelow(int bound, const std::uint16_t* index, S x) { return *index < bound ? x : 0; }
    static S positivePart(S x) { return x > 0 ? x : 0; }
    static S atMost(double bound, S x) { return x < static_cast<S>(bound) ? x : static_cast<S>(bound); }
    static S squareRoot(S x) { return std::sqrt(x); }
    static S laneSum(S x) { return x; }
    static S expOfMinus(S x) { return std::exp(-x); }
    static S fromInteger(Integer x) { return static_cast<S>(x); }
};

template <class S>
using RealOf = typename ScalarTraits<S>::Real;

template <class S>
inline constexpr int lanesOf = ScalarTraits<S>::lanes;

/// condition ? a : b, lane by lane.
template <class Condition, class S>
inline S select(const Condition& condition, const S& a, const S& b)
{
    return ScalarTraits<S>::select(condition, a, b);
}

/// x in the lanes whose index is below `bound`, 0 in the others.
template <class S>
inline S whereBelow(int bound, const std::uint16_t* index, const S& x)
{
    return ScalarTraits<S>::whereBelow(bound, index, x);
}

/// max(x, 0)
template <class S>
inline S positivePart(const S& x)
{
    return ScalarTraits<S>::positivePart(x);
}

/// min(x, bound)
template <class S>
inline S atMost(double bound, const S& x)
{
    return ScalarTraits<S>::atMost(bound, x);
}

template <class S>
inline S squareRoot(const S& x)
{
    return ScalarTraits<S>::squareRoot(x);
}

/// Sum over the lanes, always in the same order.
template <class S>
inline RealOf<S> laneSum(const S& x)
{
    return ScalarTraits<S>::laneSum(x);
}

/// e^-x for 0 <= x <= 80.
template <class S>
inline S expOfMinus(const S& x)
{
    return ScalarTraits<S>::expOfMinus(x);
}

} // namespace slosh
