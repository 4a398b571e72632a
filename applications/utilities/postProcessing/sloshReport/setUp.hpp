// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "case/Case.hpp"
#include "scene/Scene.hpp"

#include <string>
#include <utility>
#include <vector>

namespace slosh
{

/// What a case is, read as the solver reads it.
struct SetUp
{
    Scene scene;
    std::vector<std::pair<std::string, std::string>> facts; ///< in words, with units
    std::vector<double> naturalFrequencies; ///< by linear theory, [rad/s]; none where the liquid is not from wall to
                                            ///< wall or weighs nothing

    /// Throws CaseError where a dictionary is missing or wrong.
    static SetUp read(const Case& theCase);

    /// The angular frequency of the strongest line of the motion's accelerations between two times, [rad/s]; 0 for a
    /// tank at rest and where fewer than three periods of it lie between them.
    double motionFrequency(double begin, double end) const;
};

/// A number as it is read best: four digits unless asked otherwise.
std::string number(double value, int digits = 4);

} // namespace slosh
