// SPDX-License-Identifier: GPL-3.0-or-later
#include "statistics/studentsT.hpp"

#include "base/CaseError.hpp"

#include <cmath>
#include <numbers>
#include <string>

namespace slosh
{

namespace
{

void requireFreedom(std::size_t nu)
{
    if (nu == 0)
    {
        throw CaseError("0 degrees of freedom; expected at least 1 for Student's distribution");
    }
}

/// A(t|nu) of theta.
double probabilityWithin(double theta, std::size_t nu)
{
    const double sine = std::sin(theta), cosine = std::cos(theta);
    const bool isOdd = nu % 2 == 1;
    // Terms cos^k theta, k = nu - 2, nu - 4 ...: each is the one before times cos^2 theta (k - 1)/k.
    double term = isOdd ? cosine : 1, sum = nu == 1 ? 0 : term;
    for (std::size_t k = isOdd ? 3 : 2; k + 2 <= nu; k += 2)
    {
        term *= cosine * cosine * static_cast<double>(k - 1) / static_cast<double>(k);
        sum += term;
    }
    return isOdd ? 2 / std::numbers::pi * (theta + sine * sum) : sine * sum;
}

} // namespace

double studentsProbability(double t, std::size_t nu)
{
    requireFreedom(nu);
    if (!(t >= 0))
    {
        throw CaseError("t is " + std::to_string(t) + "; expected a number >= 0 for Student's distribution");
    }
    return probabilityWithin(std::atan(t / std::sqrt(static_cast<double>(nu))), nu);
}

double studentsT(double confidence, std::size_t nu)
{
    requireFreedom(nu);
    if (!(confidence > 0 && confidence < 1))
    {
        throw CaseError("confidence is " + std::to_string(confidence) + "; expected a number > 0 and < 1");
    }
    double low = 0, high = std::numbers::pi / 2;
    for (double theta = high / 2; low < theta && theta < high; theta = (low + high) / 2)
    {
        (probabilityWithin(theta, nu) < confidence ? low : high) = theta;
    }
    return std::sqrt(static_cast<double>(nu)) * std::tan(low);
}

} // namespace slosh
