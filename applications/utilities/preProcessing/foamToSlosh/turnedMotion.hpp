// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Turn.hpp"

#include "dictionary/Dictionary.hpp"

#include <map>
#include <string>

namespace slosh
{

/// A motion in turned axes: the displacement R T R^-1, where T is theirs.
struct TurnedMotion
{
    Dictionary dynamicMeshDict;
    std::map<std::string, std::string> tables; ///< "constant/6DoF.dat": its text
};

/// Of a motion that can be read, from the dictionary that has its solidBodyMotionFunction. Vectors among its entries
/// become R times theirs. Euler angles of R_x R_y R_z become those about the turned axes; where these come in another
/// order than x, y, z the motion becomes a multiMotion of several. Throws CaseError for a motion whose formula has axes
/// (SDA, unless it is roll alone about an axis that stays x), and as setTurned.
TurnedMotion turnedMotion(const Dictionary& motion, const Turn& turn, const std::string& caseFolder);

} // namespace slosh
