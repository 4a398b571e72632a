// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "case/Case.hpp"

#include <string>

namespace slosh
{

/// Which OpenFOAM a case is written for, with what shows it: "OpenFOAM 10 or later (constant/phaseProperties)",
/// "foam-extend, or OpenFOAM before 2.3 (alpha1 in system/setFieldsDict)"; "" where nothing does.
std::string dialectOf(const Case& theirs);

} // namespace slosh
