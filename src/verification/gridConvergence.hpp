// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <vector>

namespace slosh
{

// What a figure f computed with different spacings says of its own error: f = f0 + C dx^p. Spacings in any unit, from
// the finest to the coarsest, dx1 < dx2 < dx3; ratio r = dx2/dx1. Roache, J. Fluids Eng. 116 (1994) 405; Celik et al.,
// J. Fluids Eng. 130 (2008) 078001.

/// The observed order p > 0 of three grids, from the changes f2 - f1 and f3 - f2 between them:
///     (f3 - f2)/(f2 - f1) = (dx3^p - dx2^p)/(dx2^p - dx1^p).
/// The right side rises with p from log(dx3/dx2)/log(dx2/dx1) at 0, so there is one p or none: none where the figure
/// oscillates (changes of different signs), does not converge (the changes do not fall fast enough), or no longer
/// changes (f2 = f1). Throws CaseError for spacings that do not rise.
std::optional<double> orderOfThreeGrids(const std::array<double, 3>& dx, double change21, double change32);

/// Richardson's extrapolation to dx = 0, f0 = f1 + (f1 - f2)/(r^p - 1). r > 1, p > 0.
double extrapolated(double f1, double f2, double r, double p);

/// The grid convergence index of the finer grid, Fs |f2 - f1|/(r^p - 1), in the unit of the change: the width about f1
/// in which f0 lies with some confidence. Fs is safetyOfThreeGrids where p was observed, safetyOfTwoGrids where it was
/// assumed. r > 1, p > 0.
double gridConvergenceIndex(double change21, double r, double p, double Fs);
inline constexpr double safetyOfThreeGrids = 1.25;
inline constexpr double safetyOfTwoGrids = 3;

/// Where errors stop falling: the first i for which errors[i + 1] and errors[i + 2], of two successive refinements,
/// are each more than 0.9 of the one before. Nothing where there is none.
std::optional<std::size_t> errorFloor(const std::vector<double>& errors);

} // namespace slosh
