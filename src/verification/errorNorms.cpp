// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/errorNorms.hpp"

#include "base/CaseError.hpp"
#include "verification/PowerLaw.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace slosh
{

namespace
{

void requireSameSize(std::size_t a, const std::string& what, std::size_t b, const std::string& other)
{
    if (a != b)
    {
        throw CaseError("there are " + std::to_string(a) + " " + what + " and " + std::to_string(b) + " " + other);
    }
}

} // namespace

ErrorNorms errorNorms(const std::vector<double>& found, const std::vector<double>& expected)
{
    requireSameSize(found.size(), "values", expected.size(), "expected ones");
    double squares = 0, expectedSquares = 0, largest = 0, largestExpected = 0;
    for (std::size_t n = 0; n < found.size(); ++n)
    {
        const double difference = found[n] - expected[n];
        squares += difference * difference;
        expectedSquares += expected[n] * expected[n];
        // a difference that is no number must not vanish in the maximum
        largest = std::isnan(difference) ? difference : std::max(largest, std::abs(difference));
        largestExpected = std::max(largestExpected, std::abs(expected[n]));
    }
    if (!(largestExpected > 0))
    {
        throw CaseError("a relative error of " + std::to_string(found.size()) + " zero values is not defined");
    }
    return {std::sqrt(squares / expectedSquares), largest / largestExpected};
}

ObservedOrder observedOrder(const std::vector<double>& dx, const std::vector<double>& error)
{
    requireSameSize(dx.size(), "spacings", error.size(), "errors");
    const auto positive = [](double value) { return value > 0 && std::isfinite(value); };
    if (dx.size() < 3 || !std::all_of(dx.begin(), dx.end(), positive) ||
        !std::all_of(error.begin(), error.end(), positive))
    {
        throw CaseError(
            "an order needs three or more spacings and errors, all > 0; there are " + std::to_string(dx.size())
        );
    }
    const PowerLaw law = fitPowerLaw(dx, error);
    return {law.p, law.standardError};
}

} // namespace slosh
