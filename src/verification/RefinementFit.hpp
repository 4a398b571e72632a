// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include <vector>

namespace slosh
{

/// How a figure, or a whole series, depends on the spacing:
///     phi(h) = phi0 + sum_k a_k h^p_k
/// with one or two exponents p_k. A figure is a row of one number, a series a row of many, in any unit; |.| is the
/// square root of the sum of squares of a row.
struct RefinementFit
{
    std::vector<double> exponents; ///< p_k
    bool isWeighted = false;       ///< finer spacings counted more, w_i = (1/h_i)/sum_j (1/h_j), else w_i = 1/n
    Eigen::RowVectorXd limit;      ///< phi0, at h = 0
    Eigen::MatrixXd coefficients;  ///< row k: a_k
    /// sigma = sqrt(sum_i n w_i |phi_i - phi(h_i)|^2/(n - m)), m the number of parameters of a figure: phi0, the a_k,
    /// and the exponent where that is fitted, too.
    double standardDeviation = 0;

    Eigen::RowVectorXd error(double h) const; ///< phi(h) - phi0
    Eigen::RowVectorXd operator()(double h) const { return limit + error(h); }
};

/// The figures of a study: row i of `phi` was computed with the spacing h[i].
struct Refinement
{
    std::vector<double> h; ///< > 0, in any unit, finest first
    Eigen::MatrixXd phi;

    std::size_t size() const { return h.size(); }
};

/// The fit of least squares with given exponents, one or two different ones > 0. Eca & Hoekstra 2014, J. Comput. Phys.
/// 262, 104-130, Eqs. 2-4 and the weighted ones that go with them. Throws CaseError: spacings that are not > 0 or do
/// not rise, another number of figures, fewer than one spacing more than phi0 and the a_k.
RefinementFit fitWithExponents(const Refinement& study, const std::vector<double>& exponents, bool isWeighted);

/// The same with one exponent, fitted, too, between the two limits below (Eq. 1). For each p the rest is a linear
/// problem; p is the smallest of its residuals. Four spacings or more; throws CaseError as above.
RefinementFit fitWithOrder(const Refinement& study, bool isWeighted);
inline constexpr double lowestOrderTried = -2, highestOrderTried = 8;

} // namespace slosh
