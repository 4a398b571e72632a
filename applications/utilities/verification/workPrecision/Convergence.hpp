// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ErrorTable.hpp"

#include "verification/PowerLaw.hpp"

namespace slosh
{

/// How the error of one scheme falls with the spacing.
struct Convergence
{
    std::vector<const Row*> rows; ///< finished with an error > 0, coarsest first
    /// Where the error stops falling, of `rows`: two refinements after it gain less than a tenth each.
    std::optional<std::size_t> floor;
    // Of the spacing, from the coarsest run to the floor; nothing of fewer than two runs.
    std::optional<PowerLaw> error;
    std::optional<PowerLaw> cpuSeconds;
};

Convergence convergenceOf(const ErrorTable& table, const std::string& scheme);

} // namespace slosh
