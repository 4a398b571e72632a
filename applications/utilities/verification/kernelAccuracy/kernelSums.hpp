// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Vec.hpp"
#include "kernels/Kernel.hpp"

#include <vector>

namespace slosh
{

/// What a kernel makes of f = x^2 + y^2 (+ z^2) at a point X among points b of volume V, each minus the exact value:
///   f:     sum_b f_b V W(|X - x_b|) - f(X), [m^2]
///   dfdx:  sum_b f_b V dW/dx (X - x_b) - 2 X_x, the plain sum, [m]
///   unity: sum_b V W(|X - x_b|) - 1
/// Cao et al. 2014, Figs 2 and 3.
struct KernelErrors
{
    double f = 0;
    double dfdx = 0;
    double unity = 0;
    double neighbours = 0; ///< points within the support, as summed in double precision
    /// Points on the edge of the support to 1e-6 h. Rounding decides whether the truncated Gaussian counts them, whose
    /// gradient is not zero there.
    int onEdge = 0;
};

/// The sums in double precision over all points, as they are printed: the reference.
KernelErrors errorsInDouble(const Kernel& kernel, const std::vector<Vec>& points, double V, const Vec& X);

/// The same at each of `probes` by the solver's own walk over pairs, of its lists and packed records, in single
/// precision (without the counts of points).
std::vector<KernelErrors>
errorsOfPairLoop(const Kernel& kernel, const std::vector<Vec>& points, double V, const std::vector<Vec>& probes);

} // namespace slosh
