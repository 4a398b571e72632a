// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "dictionary/Range.hpp"

#include <sstream>
#include <string>

namespace slosh
{

/// ">= 0 and < 1", "" of any number.
inline std::string rangeText(const Range& range)
{
    constexpr double most = std::numeric_limits<double>::max();
    const bool hasLow = range.low > -most, hasHigh = range.high < most;
    std::ostringstream text;
    if (hasLow)
    {
        text << (range.lowIncluded ? ">= " : "> ") << range.low;
    }
    if (hasHigh)
    {
        text << (hasLow ? " and " : "") << (range.highIncluded ? "<= " : "< ") << range.high;
    }
    return text.str();
}

} // namespace slosh
