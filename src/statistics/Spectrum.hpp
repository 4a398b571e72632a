// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "statistics/TimeSeries.hpp"

#include <vector>

namespace slosh
{

/// The power spectral density of a series, one-sided, over the angular frequency: a periodogram with Hann's window
///     w_j = 1 - cos(2 pi j/n),  x_j = x(t_first + j dt) - m,  m such that sum w_j x_j = 0,  j = 0 ... n - 1
///     S(omega_k) = c |sum_j w_j x_j exp(-2 pi i j k/n)|^2/(n sum w_j^2 dOmega),  omega_k = k dOmega,
///     dOmega = 2 pi/(n dt);  c = 2, or 1 where -omega_k is omega_k itself
/// so that sum_k S dOmega = sum (w_j x_j)^2/sum w_j^2, the mean square (Parseval). A sine of amplitude A and a whole
/// number of periods in n dt has A^2/2 there, two thirds of it at its own frequency and a sixth at either neighbour.
/// Samples are taken as they stand where they are evenly spaced, else linearly between them. Harris 1978, Proceedings
/// of the IEEE 66, 51-83.
struct Spectrum
{
    double step = 0;             ///< dOmega, [rad/s]
    std::vector<double> density; ///< S(k dOmega), k = 0 ... n/2, in (the unit of the samples)^2 s/rad

    /// Throws CaseError for fewer than `fewest` samples.
    explicit Spectrum(const TimeSeries& series);
    static constexpr std::size_t fewest = 16;

    double omega(std::size_t k) const { return step * static_cast<double>(k); } ///< [rad/s]
    /// The angular frequency of the highest line, between the steps by its ratio r to the higher neighbour,
    /// sqrt(S) to sqrt(S): (2 r - 1)/(r + 1) steps towards that, which is exact for one complex exponential (Grandke
    /// 1983, IEEE Transactions on Instrumentation and Measurement 32, 350-355); to 0.01 steps for a sine of three
    /// periods or more. 0 for a constant, [rad/s].
    double strongest() const;
};

} // namespace slosh
