// SPDX-License-Identifier: GPL-3.0-or-later
#include "statistics/WeibullFit.hpp"

#include "base/CaseError.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <sstream>

namespace slosh
{

namespace
{

using std::numbers::pi;

constexpr double sixOverPiSquared = 6 / (pi * pi);
constexpr double oneMinusGamma = 1 - std::numbers::egamma;

double mean(const std::vector<double>& values)
{
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

/// ln(y_i/y_max), y = x - location: no power of them overflows.
std::vector<double> logRatios(const std::vector<double>& samples, double location)
{
    const double largest = *std::max_element(samples.begin(), samples.end()) - location;
    std::vector<double> logs;
    logs.reserve(samples.size());
    for (const double x : samples)
    {
        logs.push_back(std::log((x - location) / largest));
    }
    return logs;
}

/// The shape equation, left side minus right side, and its derivative.
struct ShapeEquation
{
    double residual, slope;

    ShapeEquation(const std::vector<double>& logs, double beta)
    {
        double sum = 0, sumLog = 0, sumLogSquared = 0;
        for (const double z : logs)
        {
            const double power = std::exp(beta * z);
            sum += power;
            sumLog += power * z;
            sumLogSquared += power * z * z;
        }
        const double weighted = sumLog / sum;
        residual = weighted - 1 / beta - mean(logs);
        slope = sumLogSquared / sum - weighted * weighted + 1 / (beta * beta);
    }
};

/// Newton's method, kept between bounds that close in on the root.
double solveShape(const std::vector<double>& logs)
{
    const double m = mean(logs);
    double variance = 0;
    for (const double z : logs)
    {
        variance += (z - m) * (z - m) / static_cast<double>(logs.size());
    }
    double beta = pi / std::sqrt(6 * variance); // by the variance of ln y
    double low = beta, high = beta;
    while (ShapeEquation(logs, low).residual > 0)
    {
        low /= 2;
    }
    while (ShapeEquation(logs, high).residual < 0)
    {
        high *= 2;
    }
    for (int k = 0; k < 200; ++k)
    {
        const ShapeEquation equation(logs, beta);
        (equation.residual < 0 ? low : high) = beta;
        double next = beta - equation.residual / equation.slope;
        if (!(next >= low && next <= high))
        {
            next = (low + high) / 2;
        }
        const double step = std::abs(next - beta);
        beta = next;
        if (step <= 4 * std::numeric_limits<double>::epsilon() * beta)
        {
            break;
        }
    }
    return beta;
}

void requireProbability(double p, const std::string& what)
{
    if (!(p > 0 && p < 1))
    {
        std::ostringstream message;
        message << "the " << what << " is " << p << "; expected between 0 and 1";
        throw CaseError(message.str());
    }
}

/// The z that a standard normal variable stays within, in absolute value, with this probability. The probability is
/// concave in z, so that Newton's method rises from 0 without passing the root.
double normalBound(double confidence)
{
    requireProbability(confidence, "confidence");
    double z = 0;
    for (double step = 1; step > 1e-15 * z;)
    {
        step = (std::erfc(z / std::numbers::sqrt2) - (1 - confidence)) * std::sqrt(pi / 2) * std::exp(z * z / 2);
        z += step;
    }
    return z;
}

/// location + y exp(-+ z deviation).
ConfidenceInterval aboutLog(double location, double y, double deviation, double confidence)
{
    const double factor = std::exp(normalBound(confidence) * deviation);
    return {location + y, location + y / factor, location + y * factor};
}

} // namespace

std::string WeibullFit::obstacle(const std::vector<double>& samples, double location)
{
    std::ostringstream message;
    if (samples.size() < fewestSamples)
    {
        message << "a Weibull fit needs " << fewestSamples << " values; there are " << samples.size();
        return message.str();
    }
    const auto [low, high] = std::minmax_element(samples.begin(), samples.end());
    if (!(*low > location))
    {
        message << "a Weibull fit needs values above its location, " << location << "; the smallest is " << *low;
    }
    // The shape that equal values ask for is infinite.
    else if (!(std::log((*high - location) / (*low - location)) > 1e-9))
    {
        message << "a Weibull fit needs different values; all are " << *low;
    }
    return message.str();
}

WeibullFit::WeibullFit(const std::vector<double>& samples, double location)
    : count_(static_cast<double>(samples.size()))
{
    if (const std::string reason = obstacle(samples, location); !reason.empty())
    {
        throw CaseError(reason);
    }
    const auto logs = logRatios(samples, location);
    const double beta = solveShape(logs);
    double power = 0;
    for (const double z : logs)
    {
        power += std::exp(beta * z) / count_;
    }
    const double largest = *std::max_element(samples.begin(), samples.end()) - location;
    weibull_ = {location, largest * std::pow(power, 1 / beta), beta};
}

ConfidenceInterval WeibullFit::shape(double confidence) const
{
    return aboutLog(0, weibull_.shape, std::sqrt(sixOverPiSquared / count_), confidence);
}

ConfidenceInterval WeibullFit::scale(double confidence) const
{
    const double variance = 1 + sixOverPiSquared * oneMinusGamma * oneMinusGamma;
    return aboutLog(0, weibull_.scale, std::sqrt(variance / count_) / weibull_.shape, confidence);
}

ConfidenceInterval WeibullFit::valueExceededBy(double probability, double confidence) const
{
    requireProbability(probability, "probability of exceedance");
    const double w = std::log(-std::log(probability));
    // The three terms of the header, gathered.
    const double variance = 1 + sixOverPiSquared * std::pow(oneMinusGamma - w, 2);
    const double y = weibull_.valueExceededBy(probability) - weibull_.location;
    return aboutLog(weibull_.location, y, std::sqrt(variance / count_) / weibull_.shape, confidence);
}

} // namespace slosh
