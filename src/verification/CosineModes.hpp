// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace slosh
{

/// Functions of s in [0, L] with zero slope at both ends, as sums of cosines and as values on a grid of P points:
///
///     f(s) = sum_n a_n cos k_n s,  k_n = n pi/L,   s_j = (j + 1/2) L/P,   n, j = 0 ... P - 1.
///
/// One is the other exactly (the discrete cosine transform, here a matrix: a few hundred points). On the grid a cosine
/// of n > P is the negative of that of 2P - n: the first N modes of a product of d functions of no more than N modes
/// are free of this aliasing where 2P > (d + 1) N.
class CosineModes
{
public:
    /// L in m, P > 0.
    CosineModes(double L, Eigen::Index P);

    const Eigen::ArrayXd& waveNumbers() const { return k_; } ///< k_n, [1/m]
    const Eigen::ArrayXd& points() const { return s_; }      ///< s_j, [m]

    // One function a column.

    /// Values on the grid, from the first amplitudes, at most P; the others are 0.
    Eigen::ArrayXXd values(const Eigen::ArrayXXd& amplitudes) const;
    /// Values of df/ds, from the same.
    Eigen::ArrayXXd slopes(const Eigen::ArrayXXd& amplitudes) const;
    /// The first `count` amplitudes of what has these values.
    Eigen::ArrayXXd amplitudes(const Eigen::ArrayXXd& values, Eigen::Index count) const;

private:
    Eigen::ArrayXd k_, s_;
    Eigen::MatrixXd cosine_, slope_, analysis_;
};

} // namespace slosh
