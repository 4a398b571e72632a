// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/numberText.hpp"

#include <string>

namespace slosh
{

/// What a product or the like of numbers with few digits is on paper, 0.001 times -285 = -0.285: rounded to 15 digits.
inline double decimal(double x)
{
    return std::stod(numberText(x, 15));
}

} // namespace slosh
