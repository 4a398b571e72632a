// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Vec.hpp"
#include "motion/RigidState.hpp"

namespace slosh
{

/// The body force the liquid feels, per unit mass, [m/s^2], in the frame the equations are solved in.
/// In the tank's frame, with everything turned into it (R^T):
///     b(X, v) = g - c'' - omega' x X - omega x (omega x X) - 2 omega x v
/// (linear, Euler, centrifugal, Coriolis); in the inertial frame b = g. What a wall particle at X feels is the same
/// with v = 0 in the tank's frame, and g - a_w in the inertial one: the (g - a_w) of Cao et al. 2014, Eq. 13.
class BodyForce
{
public:
    static BodyForce inTankFrame(const Vec& gravity, const RigidState& tank);
    static BodyForce inInertialFrame(const Vec& gravity, const RigidState& tank);

    /// On liquid at solver coordinates r with solver velocity v.
    Vec onLiquid(const Vec& r, const Vec& v) const
    {
        if (!rotates_ || !tankFrame_)
        {
            return uniform_;
        }
        return uniform_ - rotational(r) - 2 * omega_.cross(v);
    }
    /// g - a_w at solver coordinates r: the gradient of hydrostatic pressure over rho beside a wall.
    Vec atWall(const Vec& r) const { return rotates_ ? wallUniform_ - rotational(r - origin_) : wallUniform_; }

    /// How fast what atWall() holds for turns, in solver axes, [rad/s].
    const Vec& omega() const { return omega_; }

private:
    BodyForce(bool tankFrame, const Vec& uniform, const Vec& wallUniform, const Vec& origin, const Vec& omega,
              const Vec& omegaDot)
        : tankFrame_(tankFrame), rotates_(!omega.isZero(0) || !omegaDot.isZero(0)), uniform_(uniform),
          wallUniform_(wallUniform), origin_(origin), omega_(omega), omegaDot_(omegaDot)
    {
    }
    Vec rotational(const Vec& s) const { return omegaDot_.cross(s) + omega_.cross(omega_.cross(s)); }

    bool tankFrame_;
    bool rotates_;    ///< most tanks do not, at least at times: asked once, not per particle
    Vec uniform_;     ///< tank frame: R^T (g - c''); inertial: g
    Vec wallUniform_; ///< R^T (g - c''); inertial: g - c''
    Vec origin_;      ///< the tank's origin in solver coordinates
    Vec omega_;       ///< in the solver's frame, as omega'
    Vec omegaDot_;
};

} // namespace slosh
