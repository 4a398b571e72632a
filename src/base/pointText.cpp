// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/pointText.hpp"

#include "base/numberText.hpp"

namespace slosh
{

std::string text(const Vec& x)
{
    return "(" + numberText(x[0], 6) + " " + numberText(x[1], 6) + " " + numberText(x[2], 6) + ")";
}

std::string text(const Vec2& x)
{
    return "(" + numberText(x[0], 6) + " " + numberText(x[1], 6) + ")";
}

std::string exactText(const Vec& x)
{
    return "(" + numberText(x[0]) + " " + numberText(x[1]) + " " + numberText(x[2]) + ")";
}

} // namespace slosh
