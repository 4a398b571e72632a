// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Jet.hpp"
#include "base/Vec.hpp"
#include "motion/RigidState.hpp"

namespace slosh
{

/// A rigid displacement that depends on time: X -> c + R X, with the first two derivatives of both.
struct Transform
{
    using JetVec = Eigen::Matrix<Jet, 3, 1>;
    using JetMat = Eigen::Matrix<Jet, 3, 3>;

    JetVec c;
    JetMat R;

    static Transform translation(const JetVec& d);
    /// X -> origin + R (X - origin) + d.
    static Transform rotationAbout(const Vec& origin, const JetMat& R, const JetVec& d);

    /// By `angle` (rad) about the unit vector `axis`: Rodrigues' formula.
    static JetMat rotation(const Vec& axis, const Jet& angle);
    /// R_x(a_x) R_y(a_y) R_z(a_z), angles in rad: OpenFOAM's quaternion::XYZ.
    static JetMat eulerXYZ(const JetVec& angles);

    /// First `inner`, then this.
    Transform operator*(const Transform& inner) const;

    /// Velocities and accelerations from the derivatives: [omega x] = R' R^T, [omega' x] = (R'' R^T + R' R'^T).
    RigidState state() const;
};

} // namespace slosh
