// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "case/Case.hpp"
#include "particles/Particles.hpp"

#include <vector>

namespace slosh
{

/// Positions of the wall particles in tank coordinates, in the order of `particles`, [m]: as the case's first time
/// directory has them, so that no digit is lost in a turn to and fro or in an ascii file. Throws CaseError where that
/// one is not in the tank's frame or has other walls.
std::vector<Vec> wallInTank(const Case& theCase, const Particles& particles);

} // namespace slosh
