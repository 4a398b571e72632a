// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/equilibria.hpp"

#include "base/CaseError.hpp"

#include <cmath>
#include <sstream>

namespace slosh
{

namespace
{

void requireWet(double lowest)
{
    if (!(lowest >= 0))
    {
        std::ostringstream message;
        message << "the level would fall to " << lowest
                << " m below the bottom; the formula is valid only while the bottom is wet";
        throw CaseError(message.str());
    }
}

} // namespace

TiltedLevel::TiltedLevel(double L, double h, double ax, double ay, double g) : h_(h), ax_(ax), g_(g + ay)
{
    requireWet(h_ - std::abs(ax_) / g_ * L / 2);
}

RotatingLevel::RotatingLevel(double meanSquare, double h, double w, double g)
    : meanSquare_(meanSquare), h_(h), g_(g), curvature_(w * w / (2 * g))
{
    requireWet(eta(0));
}

RotatingLevel RotatingLevel::cylinder(double R, double h, double w, double g)
{
    return {R * R / 2, h, w, g};
}

RotatingLevel RotatingLevel::slot(double L, double h, double w, double g)
{
    return {L * L / 12, h, w, g};
}

RotatingLevel RotatingLevel::box(double a, double b, double h, double w, double g)
{
    return {(a * a + b * b) / 12, h, w, g};
}

} // namespace slosh
