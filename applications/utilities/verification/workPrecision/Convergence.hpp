// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ErrorTable.hpp"

#include "verification/PowerLaw.hpp"

namespace slosh
{

/// What the runs of one scheme at different spacings say together.
struct Convergence
{
    std::vector<const Row*> rows; ///< finished with an error > 0, coarsest first
    /// Where the error stops falling, of `rows`: two refinements after it gain less than a tenth each.
    std::optional<std::size_t> floor;
    // Of the spacing, from the coarsest run to the floor; nothing of fewer than two runs.
    std::optional<PowerLaw> error;
    std::optional<PowerLaw> cpuSeconds;

    // Of the figure itself, or of the whole series where the quantity is a difference: how much it changes from grid to
    // grid, whatever the reference says.
    int grids = 0;               ///< that the index is made of: 3, 2 or 0
    std::optional<double> order; ///< observed on the three finest grids
    /// Of the finest grid: a share of the figure, or of the motion of the reference. Assumes the formal order where
    /// there are two grids; NaN where three have no order.
    double gridConvergenceIndex = Outcome::unknown;
};

Convergence convergenceOf(const ErrorTable& table, const std::string& scheme, double formalOrder);

} // namespace slosh
