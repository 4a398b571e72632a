// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>

namespace slosh
{

/// The values an entry may have; NaN is never inside.
struct Range
{
    double low = -std::numeric_limits<double>::infinity();
    double high = std::numeric_limits<double>::infinity();
    bool lowIncluded = true;
    bool highIncluded = true;

    bool contains(double x) const
    {
        return (lowIncluded ? x >= low : x > low) && (highIncluded ? x <= high : x < high);
    }
};

/// Any finite number.
inline constexpr Range anyNumber{-std::numeric_limits<double>::max(), std::numeric_limits<double>::max()};
inline constexpr Range positive{0, std::numeric_limits<double>::max(), false, true};
inline constexpr Range notNegative{0, std::numeric_limits<double>::max(), true, true};
constexpr Range between(double low, double high)
{
    return {low, high};
}
constexpr Range atLeast(double low)
{
    return {low, std::numeric_limits<double>::max()};
}

} // namespace slosh
