// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/CosineModes.hpp"

#include <numbers>

namespace slosh
{

namespace
{

Eigen::ArrayXd counted(Eigen::Index P)
{
    return Eigen::ArrayXd::LinSpaced(P, 0, static_cast<double>(P - 1));
}

} // namespace

CosineModes::CosineModes(double L, Eigen::Index P)
    : k_(counted(P) * std::numbers::pi / L), s_((counted(P) + 0.5) * L / static_cast<double>(P))
{
    const Eigen::ArrayXXd phase = (s_.matrix() * k_.matrix().transpose()).array();
    cosine_ = phase.cos();
    slope_ = -(phase.sin().rowwise() * k_.transpose());
    analysis_ = cosine_.transpose() * 2 / static_cast<double>(P);
    analysis_.row(0) /= 2;
}

Eigen::ArrayXXd CosineModes::values(const Eigen::ArrayXXd& amplitudes) const
{
    return (cosine_.leftCols(amplitudes.rows()) * amplitudes.matrix()).array();
}

Eigen::ArrayXXd CosineModes::slopes(const Eigen::ArrayXXd& amplitudes) const
{
    return (slope_.leftCols(amplitudes.rows()) * amplitudes.matrix()).array();
}

Eigen::ArrayXXd CosineModes::amplitudes(const Eigen::ArrayXXd& values, Eigen::Index count) const
{
    return (analysis_.topRows(count) * values.matrix()).array();
}

} // namespace slosh
