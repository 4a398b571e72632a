// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "dictionary/Dictionary.hpp"

#include <algorithm>
#include <limits>

namespace slosh
{

/// What system/controlDict says of the time step.
struct TimeStepControl
{
    bool adjust = false;
    double deltaT = 0;           ///< [s]; 0 where it is adjusted and none is given
    double maxCo = 0.25;         ///< c0-based Courant number (integration/timeStep.hpp): stable with a margin
    bool maxCoIsDefault = false; ///< the case does not say it itself
    double maxDeltaT = std::numeric_limits<double>::infinity(); ///< [s]

    /// Throws CaseError.
    static TimeStepControl read(const Dictionary& controlDict);

    /// Where the case does not say maxCo itself, it is at most `most`.
    double maxCoUpTo(double most) const { return maxCoIsDefault ? std::min(maxCo, most) : maxCo; }
};

/// Its entries in system/controlDict.
Keys timeStepKeys();

} // namespace slosh
