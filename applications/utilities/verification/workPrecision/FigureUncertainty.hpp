// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ErrorTable.hpp"

#include "verification/numericalUncertainty.hpp"

#include <optional>

namespace slosh
{

/// The figure at one spacing: of one run, or the mean over the members of an ensemble.
struct FigureAtSpacing
{
    std::vector<const Row*> rows; ///< one for each member
    double spacing = Outcome::unknown;
    double figure = Outcome::unknown; ///< of a series none
    /// Half width of its 95 % interval, t s with Student's t of n - 1 degrees of freedom: s = deviation/sqrt(n) of n
    /// members, else the standard error of the run's mean over n periods. NaN where the figure is neither.
    double scatter = Outcome::unknown;
    std::size_t count = 0; ///< n
    double cpuSeconds = 0; ///< of all members
};

/// What the finished runs at different spacings, alike in all else, say of the figure itself, whatever the reference
/// says. A quantity `difference` has a series instead of a figure, in units of sqrt(sum (r - mean r)^2) of the finest
/// run's reference r; of an ensemble it is that of the first member.
struct FigureUncertainty
{
    const Comparison* comparison = nullptr;
    std::vector<FigureAtSpacing> figures;     ///< finest first
    std::optional<NumericalUncertainty> band; ///< of the finest; nothing of fewer than four spacings
    double change = Outcome::unknown;         ///< |f2 - f1| of the two finest

    const FigureAtSpacing& finest() const { return figures.front(); }
    /// What uncertainties are a share of, or 0 where they are given in the unit of the figure.
    double size() const;
};

/// `rows`: of one family, coarsest first.
FigureUncertainty
figureUncertainty(const std::vector<const Row*>& rows, const Comparison& comparison, double schemeOrder);

} // namespace slosh
