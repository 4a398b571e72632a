// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/numericalUncertainty.hpp"

#include "base/CaseError.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace slosh
{

namespace
{

constexpr double safetyOfGoodFits = 1.25, safetyOfOthers = 3;
constexpr double closeToFit = 0.1; ///< sigma/Delta of a fit that may be narrower than the last change
constexpr std::array<bool, 2> withoutAndWithWeights{false, true};

RefinementFit closest(const std::vector<RefinementFit>& fits)
{
    return *std::min_element(
        fits.begin(), fits.end(),
        [](const RefinementFit& a, const RefinementFit& b) { return a.standardDeviation < b.standardDeviation; }
    );
}

double dataRangeOf(const Eigen::MatrixXd& phi)
{
    double largest = 0;
    for (Eigen::Index i = 0; i < phi.rows(); ++i)
    {
        for (Eigen::Index j = 0; j < i; ++j)
        {
            largest = std::max(largest, (phi.row(i) - phi.row(j)).norm());
        }
    }
    return largest / static_cast<double>(phi.rows() - 1);
}

/// Order and fit.
void chooseFit(NumericalUncertainty& result, const Refinement& study, double schemeOrder)
{
    std::vector<RefinementFit> free, kept;
    for (const bool isWeighted : withoutAndWithWeights)
    {
        free.push_back(fitWithOrder(study, isWeighted));
        const double p = free.back().exponents.front();
        if (p >= lowestOrder && p <= schemeOrder)
        {
            kept.push_back(free.back());
        }
    }
    result.isOrderKept = !kept.empty();
    result.fit = closest(result.isOrderKept ? kept : free);
    result.order = result.fit.exponents.front();
    if (result.isOrderKept)
    {
        return;
    }
    std::vector<RefinementFit> fixed;
    for (const bool isWeighted : withoutAndWithWeights)
    {
        fixed.push_back(fitWithExponents(study, {1}, isWeighted));
        if (schemeOrder > 1)
        {
            fixed.push_back(fitWithExponents(study, {schemeOrder}, isWeighted));
            if (result.order < lowestOrder)
            {
                fixed.push_back(fitWithExponents(study, {1, schemeOrder}, isWeighted));
            }
        }
    }
    result.fit = closest(fixed);
}

double otherLimitOf(const RefinementFit& fit, const Refinement& study, double schemeOrder)
{
    double largest = 0;
    if (schemeOrder > 1)
    {
        for (const bool isWeighted : withoutAndWithWeights)
        {
            const RefinementFit other = fitWithExponents(study, {1, schemeOrder}, isWeighted);
            if (other.standardDeviation < fit.standardDeviation)
            {
                largest = std::max(largest, (other.limit - fit.limit).norm());
            }
        }
    }
    return largest;
}

/// All that depends on the fit alone.
NumericalUncertainty fitted(const Refinement& study, double schemeOrder)
{
    NumericalUncertainty result;
    chooseFit(result, study, schemeOrder);
    const double finest = study.h.front();
    result.dataRange = dataRangeOf(study.phi);
    result.error = result.fit.error(finest).norm();
    result.deviation = (study.phi.row(0) - result.fit(finest)).norm();
    result.change = (study.phi.row(1) - study.phi.row(0)).norm();
    return result;
}

double scatterOf(
    const NumericalUncertainty& result, const Refinement& study, const std::vector<double>& scatter, double schemeOrder
)
{
    if (scatter.empty())
    {
        return 0;
    }
    double squares = scatter.front() * scatter.front();
    for (std::size_t i = 0; i < scatter.size(); ++i)
    {
        double largest = 0;
        for (const double moved : {-scatter[i], scatter[i]})
        {
            Refinement other = study;
            other.phi(static_cast<Eigen::Index>(i), 0) += moved;
            largest = std::max(largest, std::abs(fitted(other, schemeOrder).error - result.error));
        }
        squares += largest * largest;
    }
    return std::sqrt(squares);
}

void setDiscretisation(NumericalUncertainty& result, double schemeOrder)
{
    const double sigma = result.fit.standardDeviation;
    const bool isGood = result.order >= lowestOrder && result.order < schemeOrder + orderTolerance &&
                        sigma < result.dataRange && result.scatter <= result.error;
    result.safetyFactor = isGood ? safetyOfGoodFits : safetyOfOthers;
    const double more = sigma + result.deviation + result.otherLimit;
    result.discretisation = result.isFollowed() ? result.safetyFactor * result.error + more
                                                : safetyOfOthers * sigma / result.dataRange * (result.error + more);
    const bool hasEarnedLess = isGood && sigma < closeToFit * result.dataRange;
    result.isChange = !hasEarnedLess && result.discretisation < result.change;
    result.discretisation = result.isChange ? result.change : result.discretisation;
}

} // namespace

double NumericalUncertainty::total() const
{
    return std::hypot(discretisation, scatter);
}

NumericalUncertainty
numericalUncertainty(const Refinement& study, const std::vector<double>& scatter, double schemeOrder)
{
    if (!(schemeOrder >= 1))
    {
        throw CaseError("the order of a scheme is " + std::to_string(schemeOrder) + "; expected at least 1");
    }
    if (!scatter.empty() && (scatter.size() != study.size() || study.phi.cols() != 1))
    {
        throw CaseError(
            std::to_string(scatter.size()) + " half widths for " + std::to_string(study.size()) +
            " spacings; expected one for the figure of each spacing"
        );
    }
    NumericalUncertainty result = fitted(study, schemeOrder);
    result.otherLimit = otherLimitOf(result.fit, study, schemeOrder);
    result.scatter = scatterOf(result, study, scatter, schemeOrder);
    setDiscretisation(result, schemeOrder);
    return result;
}

} // namespace slosh
