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
    Vec onLiquid(const Vec& r, const Vec& v) const;
    /// g - a_w at solver coordinates r: the gradient of hydrostatic pressure over rho beside a wall.
    Vec atWall(const Vec& r) const;

private:
    bool tankFrame_ = true;
    Vec uniform_ = Vec::Zero();  ///< tank frame: R^T (g - c''); inertial: g
    Vec omega_ = Vec::Zero();    ///< in the solver's frame
    Vec omegaDot_ = Vec::Zero(); ///< in the solver's frame
    Vec wallUniform_ = Vec::Zero();
    Vec origin_ = Vec::Zero(); ///< the tank's origin in solver coordinates
};

} // namespace slosh
