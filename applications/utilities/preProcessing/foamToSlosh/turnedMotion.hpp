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

/// Of a motion that can be read, from the dictionary that holds its solidBodyMotionFunction. Points, directions and
/// displacements become R times theirs. Euler angles of R_x R_y R_z become those about the turned axes; where these
/// come in another order than x, y, z the motion becomes a multiMotion of several. Throws CaseError for what has its
/// axes in its formula (SDA), and for vectors that are given by a Function1 other than constant and table.
TurnedMotion turnedMotion(const Dictionary& motion, const Turn& turn, const std::string& caseFolder);

} // namespace slosh
