// SPDX-License-Identifier: GPL-3.0-or-later
#include "statistics/Spectrum.hpp"

#include "base/CaseError.hpp"

#include <unsupported/Eigen/FFT>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <string>

namespace slosh
{

namespace
{

/// The least number >= n without a prime factor above 5: a fast transform takes that many.
std::size_t smoothNumber(std::size_t n)
{
    for (;; ++n)
    {
        std::size_t rest = n;
        for (const std::size_t prime : {2, 3, 5})
        {
            while (rest % prime == 0)
            {
                rest /= prime;
            }
        }
        if (rest == 1)
        {
            return n;
        }
    }
}

/// n values at even distances from the first sample to the last.
std::vector<double> evenly(const TimeSeries& series, std::size_t n)
{
    const double begin = series.t.front(), length = series.t.back() - begin;
    std::vector<double> values(n);
    for (std::size_t j = 0; j < n; ++j)
    {
        const double t = begin + length * static_cast<double>(j) / static_cast<double>(n - 1);
        values[j] = series.at(std::min(t, series.t.back()));
    }
    return values;
}

} // namespace

Spectrum::Spectrum(const TimeSeries& series)
{
    if (series.size() < fewest)
    {
        throw CaseError(
            "a spectrum has " + std::to_string(series.size()) + " samples; expected " + std::to_string(fewest) +
            " or more"
        );
    }
    const std::size_t n = smoothNumber(series.size());
    std::vector<double> x = evenly(series, n), window(n);
    double sum = 0, squares = 0, mean = 0;
    for (std::size_t j = 0; j < n; ++j)
    {
        window[j] = 1 - std::cos(2 * std::numbers::pi * static_cast<double>(j) / static_cast<double>(n));
        sum += window[j];
        squares += window[j] * window[j];
        mean += window[j] * x[j];
    }
    mean /= sum;
    for (std::size_t j = 0; j < n; ++j)
    {
        x[j] = window[j] * (x[j] - mean);
    }

    Eigen::FFT<double> transform;
    std::vector<std::complex<double>> X;
    transform.fwd(X, x);
    const double period = (series.t.back() - series.t.front()) * static_cast<double>(n) / static_cast<double>(n - 1);
    step = 2 * std::numbers::pi / period;
    for (std::size_t k = 0; k <= n / 2; ++k)
    {
        const double both = k == 0 || 2 * k == n ? 1 : 2;
        density.push_back(both * std::norm(X[k]) / (static_cast<double>(n) * squares * step));
    }
}

double Spectrum::strongest() const
{
    const auto k = static_cast<std::size_t>(std::max_element(density.begin(), density.end()) - density.begin());
    if (k == 0 || k + 1 == density.size() || density[k] <= 0)
    {
        return omega(k);
    }
    const bool above = density[k + 1] > density[k - 1];
    const double ratio = std::sqrt(density[above ? k + 1 : k - 1] / density[k]);
    const double shift = (2 * ratio - 1) / (ratio + 1);
    return step * (static_cast<double>(k) + (above ? shift : -shift));
}

} // namespace slosh
