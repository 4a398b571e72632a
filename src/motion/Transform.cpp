// SPDX-License-Identifier: GPL-3.0-or-later
#include "motion/Transform.hpp"

namespace slosh
{

namespace
{

Transform::JetVec constant(const Vec& x)
{
    return {Jet(x[0]), Jet(x[1]), Jet(x[2])};
}

/// Derivative number k of every element.
template <class Result, class Jets>
Result derivative(const Jets& jets, int k)
{
    Result result;
    for (Eigen::Index i = 0; i < jets.size(); ++i)
    {
        const Jet& jet = jets(i);
        result(i) = k == 0 ? jet.f : k == 1 ? jet.d : jet.dd;
    }
    return result;
}

/// The vector w of the antisymmetric part of A: A x = w x x.
Vec axial(const Mat& A)
{
    return Vec(A(2, 1) - A(1, 2), A(0, 2) - A(2, 0), A(1, 0) - A(0, 1)) / 2;
}

} // namespace

Transform Transform::translation(const JetVec& d)
{
    return {d, JetMat::Identity()};
}

Transform Transform::rotationAbout(const Vec& origin, const JetMat& R, const JetVec& d)
{
    const JetVec o = constant(origin);
    return {o - R * o + d, R};
}

Transform::JetMat Transform::rotation(const Vec& axis, const Jet& angle)
{
    const Vec a = axis.normalized();
    const Jet s = sin(angle), oneMinusC = Jet(1) - cos(angle);
    Mat K;
    K << 0, -a[2], a[1], a[2], 0, -a[0], -a[1], a[0], 0;
    const Mat K2 = K * K;
    JetMat R = JetMat::Identity();
    for (Eigen::Index i = 0; i < 9; ++i)
    {
        R(i) += s * Jet(K(i)) + oneMinusC * Jet(K2(i));
    }
    return R;
}

Transform::JetMat Transform::eulerXYZ(const JetVec& angles)
{
    const JetMat Rx = rotation(Vec::UnitX(), angles[0]);
    const JetMat Ry = rotation(Vec::UnitY(), angles[1]);
    const JetMat Rz = rotation(Vec::UnitZ(), angles[2]);
    return Rx * Ry * Rz;
}

Transform Transform::operator*(const Transform& inner) const
{
    return {c + R * inner.c, R * inner.R};
}

RigidState Transform::state() const
{
    RigidState state;
    state.c = derivative<Vec>(c, 0);
    state.velocity = derivative<Vec>(c, 1);
    state.acceleration = derivative<Vec>(c, 2);
    state.R = derivative<Mat>(R, 0);
    const Mat R1 = derivative<Mat>(R, 1), R2 = derivative<Mat>(R, 2);
    state.omega = axial(R1 * state.R.transpose());
    state.omegaDot = axial(R2 * state.R.transpose() + R1 * R1.transpose());
    return state;
}

} // namespace slosh
