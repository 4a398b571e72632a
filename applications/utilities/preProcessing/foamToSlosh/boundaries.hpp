// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "BlockMesh.hpp"

#include "case/Case.hpp"

#include <string>
#include <vector>

namespace slosh
{

/// Tells of patches that are no walls, by their type and by the condition of U: in our tank they are.
void warnOfPatches(const Case& interFoamCase, const BlockMesh& mesh, std::vector<std::string>& warnings);

} // namespace slosh
