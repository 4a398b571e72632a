// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Vec.hpp"

namespace slosh
{

/// Area of the part of a disc about (0, 0) that lies in the rectangle from `low` to `high`, [m^2]: the integral over x
/// of the length of the disc's vertical chord, |y| < sqrt(R^2 - x^2), between low.y and high.y, in closed form.
double areaOfDisc(double radius, const Vec2& low, const Vec2& high);

} // namespace slosh
