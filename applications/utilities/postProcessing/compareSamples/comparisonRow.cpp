// SPDX-License-Identifier: GPL-3.0-or-later
#include "comparisonRow.hpp"

#include "base/numberText.hpp"
#include "statistics/comparisonKeys.hpp"

#include <algorithm>
#include <cmath>

namespace slosh
{

namespace
{

std::string number(double value, int digits = 5)
{
    return numberText(value, digits);
}

/// With its unit, " Pa" or ""; what did not come about, "none".
std::string figureText(const Estimate& estimate, const std::string& unit)
{
    if (std::isnan(estimate.value))
    {
        return "none";
    }
    return number(estimate.value) +
           (std::isfinite(estimate.uncertainty) ? " +- " + number(estimate.uncertainty, 2) : "") + unit;
}

std::string percent(double share)
{
    return number(100 * share, 3) + " %";
}

double distanceFrom(const std::pair<double, double>& range, double value)
{
    return value - std::clamp(value, range.first, range.second);
}

void sayRatio(ComparisonRow& row, const Dictionary& dict, double ratio)
{
    row.value = ratio;
    row.figure = number(ratio, 3);
    row.reference = row.error = "-";
    if (dict.has(comparison::stated))
    {
        const double stated = dict.scalar(comparison::stated);
        row.off = ratio - stated;
        row.reference = number(stated, 3);
        row.error = number(row.off, 2);
    }
}

/// The quantities that are no figure of one series but a relation of two. False: it is none of them.
bool compareSeries(ComparisonRow& row, const Reference& reference, const TimeSeries& samples, const Dictionary& dict)
{
    const std::string quantity = dict.word(comparison::quantity);
    if (quantity == "difference")
    {
        if (!reference.series)
        {
            throw dict.errorAt(referenceKey(), "is not a series; expected a series for quantity difference");
        }
        row.off = row.value = relativeDifference(samples, *reference.series);
        row.figure = row.error = percent(row.off);
        row.reference = "0";
        return true;
    }
    if (quantity == "shareInside")
    {
        if (!reference.band)
        {
            throw dict.errorAt(
                referenceKey(), "has no lowColumn and highColumn; expected both for quantity shareInside"
            );
        }
        row.value = shareInside(samples, reference.band->first, reference.band->second);
        row.figure = percent(row.value);
        row.reference = "95 %";
        row.error = "-";
        return true;
    }
    return false;
}

} // namespace

ComparisonRow compareWith(const Reference& reference, const TimeSeries& samples, const Dictionary& dict)
{
    ComparisonRow row;
    row.source = reference.source;
    const std::string unitName = dict.wordOr(comparison::unit, "");
    const std::string after = unitName.empty() ? "" : " " + unitName;
    if (compareSeries(row, reference, samples, dict))
    {
        return row;
    }
    const Quantity figureOf = readQuantity(dict);
    const Estimate figure = figureOf(samples);
    row.value = figure.value;
    row.uncertainty = figure.uncertainty;
    row.count = figure.count;
    row.figure = figureText(figure, after);
    if (reference.range)
    {
        row.off = distanceFrom(*reference.range, figure.value);
        row.reference = number(reference.range->first) + " to " + number(reference.range->second) + after;
        row.error = std::isnan(row.off) ? "none" : row.off == 0 ? "inside" : number(row.off, 3) + " outside";
        return row;
    }
    if (!reference.figure && !reference.series)
    {
        row.reference = row.error = "-";
        return row;
    }
    const Estimate other = reference.figure ? *reference.figure : figureOf(*reference.series);
    if (dict.flag(comparison::ratio))
    {
        sayRatio(row, dict, figure.value / other.value);
        return row;
    }
    row.expected = other.value;
    row.expectedUncertainty = other.uncertainty;
    row.reference = figureText(other, after);
    if (std::isnan(figure.value) || std::isnan(other.value))
    {
        row.error = "-";
        return row;
    }
    const double difference = figure.value - other.value;
    // Relative to what an instant is off has no meaning: where time begins is anybody's choice.
    const std::string quantity = dict.word(comparison::quantity);
    if (quantity == "timeOfMaximum" || quantity == "firstTimeAbove" || other.value == 0)
    {
        row.off = difference;
        row.error = number(difference, 3) + after;
    }
    else
    {
        row.off = difference / std::abs(other.value);
        row.error = percent(row.off);
    }
    return row;
}

} // namespace slosh
