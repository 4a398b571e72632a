// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/bodyForceIn.hpp"

#include "dictionary/Dictionary.hpp"
#include "motion/SolidBodyMotion.hpp"

#include <gtest/gtest.h>

namespace slosh
{
namespace
{

TEST(BodyForce, InTheTanksFrameIsWhatAParticleFreeOfForcesSeems)
{
    // A point that flies free in the inertial frame, seen from the tank: X'' = b(X, X').
    const auto motion = SolidBodyMotion::read(
        Dictionary::parse(
            "solidBodyMotionFunction multiMotion; multiMotionCoeffs { sway { solidBodyMotionFunction "
            "oscillatingLinearMotion; oscillatingLinearMotionCoeffs { amplitude (0 0.02 0); omega 3; } } "
            "roll { solidBodyMotionFunction oscillatingRotatingMotion; oscillatingRotatingMotionCoeffs { "
            "origin (0 0 0.2); amplitude (10 0 4); omega 5; } } }",
            "constant/dynamicMeshDict"
        ),
        "."
    );
    const Vec g(0, 0, -9.81), x0(0.3, -0.2, 0.1), v0(0.5, 0.2, 2);
    const auto seen = [&](double t) { return Vec(motion->at(t).pointToTank(x0 + v0 * t + 0.5 * g * t * t)); };
    constexpr double t = 0.43, h = 1e-4;
    const Vec X = seen(t), V = (seen(t + h) - seen(t - h)) / (2 * h),
              A = (seen(t + h) - 2 * seen(t) + seen(t - h)) / (h * h);
    const RigidState state = motion->at(t);
    const BodyForce tank = bodyForceIn({Frame::tank, state}, g);
    EXPECT_NEAR((tank.onLiquid(X, V) - A).norm(), 0, 1e-5);
    // A wall feels g - a_w, the same vector in either frame.
    const BodyForce inertial = bodyForceIn({Frame::inertial, state}, g);
    EXPECT_NEAR((inertial.onLiquid(state.pointToInertial(X), V) - g).norm(), 0, 0);
    EXPECT_NEAR((inertial.onRestingLiquid(state.pointToInertial(X)) - (g - state.accelerationAt(X))).norm(), 0, 1e-13);
    EXPECT_NEAR((state.R * tank.onRestingLiquid(X) - (g - state.accelerationAt(X))).norm(), 0, 1e-13);
}

} // namespace
} // namespace slosh
