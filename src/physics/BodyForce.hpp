// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Vec.hpp"

namespace slosh
{

/// The body force per unit mass, [m/s^2], as numbers: on liquid at r with the velocity v,
///     b(r, v) = uniform - e(r) - 2 omega x v,   e(r) = omega' x s + omega x (omega x s),   s = r - origin,
/// without the last two where `fictitious` is not set (the inertial frame); and g - a_w, what liquid at rest with the
/// walls feels, Cao et al. 2014, Eq. 13,
///     b_w(r) = wallUniform - e(r).
/// physics/bodyForceIn.hpp has them for a tank that moves.
struct BodyForce
{
    bool rotates = false;    ///< omega or omega' is not zero: most tanks do not, at least at times
    bool fictitious = false; ///< the frame is the tank's
    Vec uniform = Vec::Zero();
    Vec wallUniform = Vec::Zero();
    Vec origin = Vec::Zero();  ///< what the tank turns about, [m]
    Vec omega = Vec::Zero();   ///< how the tank turns, along the solver's axes, [rad/s]
    Mat turning = Mat::Zero(); ///< e = turning s, [1/s^2]

    /// g alone, in a tank at rest.
    static BodyForce gravity(const Vec& g)
    {
        BodyForce force;
        force.uniform = force.wallUniform = g;
        return force;
    }

    Vec onLiquid(const Vec& r, const Vec& v) const
    {
        return rotates && fictitious ? Vec(uniform - turning * (r - origin) - 2 * omega.cross(v)) : uniform;
    }
    Vec onRestingLiquid(const Vec& r) const
    {
        return rotates ? Vec(wallUniform - turning * (r - origin)) : wallUniform;
    }
};

} // namespace slosh
