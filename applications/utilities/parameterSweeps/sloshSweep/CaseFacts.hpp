// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "study/DictionaryFiles.hpp"

#include <optional>
#include <vector>

namespace slosh
{

/// What a case's dictionaries say of its liquid and its motion before it is run.
struct CaseFacts
{
    std::vector<double> naturalFrequencies; ///< omega_1 <= omega_2 ..., linear theory, [rad/s]; none without gravity
                                            ///< or where the liquid does not reach from wall to wall
    std::optional<double> omega;            ///< of the tank's harmonic motion, [rad/s]
    double endTime = 0;                     ///< [s]
};

/// Those of a case with these dictionaries, `modes` frequencies. They are read by the readers of the solver, in a
/// temporary folder. Throws CaseError for what is wrong in tankProperties, g, dynamicMeshDict and for a missing
/// endTime.
CaseFacts caseFacts(const DictionaryFiles& files, int modes);

} // namespace slosh
