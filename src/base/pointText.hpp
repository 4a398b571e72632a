// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Vec.hpp"

#include <string>

namespace slosh
{

/// "(x y z)", six digits each.
std::string text(const Vec& x);
std::string text(const Vec2& x); ///< "(x y)"
/// "(x y z)", with the fewest digits that read back (base/numberText.hpp).
std::string exactText(const Vec& x);

} // namespace slosh
