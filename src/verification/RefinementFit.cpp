// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/RefinementFit.hpp"

#include "base/CaseError.hpp"

#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <string>

namespace slosh
{

namespace
{

void requireSpacings(const Refinement& study, std::size_t parameters)
{
    const auto& h = study.h;
    const bool rises = !h.empty() && h.front() > 0 &&
                       std::adjacent_find(h.begin(), h.end(), [](double a, double b) { return !(a < b); }) == h.end();
    if (!rises || study.phi.rows() != std::ssize(h) || !study.phi.allFinite())
    {
        throw CaseError("a fit over the spacing needs spacings > 0, the finest first, and a figure for each");
    }
    if (h.size() <= parameters)
    {
        throw CaseError(
            "a fit of " + std::to_string(parameters) + " parameters over " + std::to_string(h.size()) +
            " spacings; expected at least " + std::to_string(parameters + 1)
        );
    }
}

/// sqrt(n w_i): what rows are multiplied by.
Eigen::VectorXd rootWeights(const std::vector<double>& h, bool isWeighted)
{
    Eigen::VectorXd weight = Eigen::VectorXd::Ones(std::ssize(h));
    if (isWeighted)
    {
        weight = Eigen::Map<const Eigen::VectorXd>(h.data(), std::ssize(h)).cwiseInverse();
        weight /= weight.mean();
    }
    return weight.cwiseSqrt();
}

/// (h^p - 1)/p, log h at p = 0. With 1 it spans what 1 and h^p span, but stays apart from 1 where p is small.
double shiftedPower(double h, double p)
{
    const double x = p * std::log(h);
    return x == 0 ? std::log(h) : std::expm1(x) / p;
}

struct LinearFit
{
    Eigen::MatrixXd coefficients;
    double residual = 0; ///< square root of the weighted sum of squares
};

LinearFit leastSquares(const Eigen::MatrixXd& basis, const Eigen::MatrixXd& phi, const Eigen::VectorXd& rootWeight)
{
    const Eigen::MatrixXd A = rootWeight.asDiagonal() * basis, b = rootWeight.asDiagonal() * phi;
    LinearFit fit;
    fit.coefficients = A.colPivHouseholderQr().solve(b);
    fit.residual = (A * fit.coefficients - b).norm();
    return fit;
}

/// 1 and the shifted powers of h/h_0.
Eigen::MatrixXd basisOf(const std::vector<double>& h, const std::vector<double>& exponents)
{
    Eigen::MatrixXd basis = Eigen::MatrixXd::Ones(std::ssize(h), std::ssize(exponents) + 1);
    for (Eigen::Index i = 0; i < basis.rows(); ++i)
    {
        for (Eigen::Index k = 1; k < basis.cols(); ++k)
        {
            const auto p = exponents[static_cast<std::size_t>(k - 1)];
            basis(i, k) = shiftedPower(h[static_cast<std::size_t>(i)] / h.front(), p);
        }
    }
    return basis;
}

RefinementFit
fitOf(const Refinement& study, const std::vector<double>& exponents, bool isWeighted, std::size_t parameters)
{
    const LinearFit linear = leastSquares(basisOf(study.h, exponents), study.phi, rootWeights(study.h, isWeighted));
    RefinementFit fit;
    fit.exponents = exponents;
    fit.isWeighted = isWeighted;
    fit.limit = linear.coefficients.row(0);
    fit.coefficients = linear.coefficients.bottomRows(std::ssize(exponents));
    for (Eigen::Index k = 0; k < fit.coefficients.rows(); ++k)
    {
        // b ((h/h_0)^p - 1)/p = -b/p + b/(p h_0^p) h^p
        const double p = exponents[static_cast<std::size_t>(k)];
        fit.limit -= fit.coefficients.row(k) / p;
        fit.coefficients.row(k) /= p * std::pow(study.h.front(), p);
    }
    fit.standardDeviation = linear.residual / std::sqrt(static_cast<double>(study.size() - parameters));
    return fit;
}

} // namespace

Eigen::RowVectorXd RefinementFit::error(double h) const
{
    Eigen::RowVectorXd sum = Eigen::RowVectorXd::Zero(limit.size());
    for (Eigen::Index k = 0; k < coefficients.rows(); ++k)
    {
        sum += std::pow(h, exponents[static_cast<std::size_t>(k)]) * coefficients.row(k);
    }
    return sum;
}

RefinementFit fitWithExponents(const Refinement& study, const std::vector<double>& exponents, bool isWeighted)
{
    requireSpacings(study, exponents.size() + 1);
    return fitOf(study, exponents, isWeighted, exponents.size() + 1);
}

RefinementFit fitWithOrder(const Refinement& study, bool isWeighted)
{
    constexpr std::size_t parameters = 3;
    requireSpacings(study, parameters);
    const Eigen::VectorXd rootWeight = rootWeights(study.h, isWeighted);
    const auto residual = [&](double p) { return leastSquares(basisOf(study.h, {p}), study.phi, rootWeight).residual; };

    // The residual has few minima over p: the best of a grid, then golden sections about it.
    constexpr double step = 0.25, precision = 1e-9, golden = 0.6180339887498949;
    double best = lowestOrderTried, least = residual(best);
    for (double p = lowestOrderTried + step; p <= highestOrderTried; p += step)
    {
        if (const double here = residual(p); here < least)
        {
            best = p;
            least = here;
        }
    }
    double low = std::max(best - step, lowestOrderTried), high = std::min(best + step, highestOrderTried);
    double left = high - golden * (high - low), right = low + golden * (high - low);
    double atLeft = residual(left), atRight = residual(right);
    while (high - low > precision)
    {
        if (atLeft < atRight)
        {
            high = right;
            right = left;
            atRight = atLeft;
            left = high - golden * (high - low);
            atLeft = residual(left);
        }
        else
        {
            low = left;
            left = right;
            atLeft = atRight;
            right = low + golden * (high - low);
            atRight = residual(right);
        }
    }
    return fitOf(study, {(low + high) / 2}, isWeighted, parameters);
}

} // namespace slosh
