// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "BlockMesh.hpp"

#include "case/Case.hpp"

namespace slosh
{

/// The blockMeshDict of an interFoam case. Throws CaseError where it has none, with what to do: where m4 is to write
/// it, where it has another name.
BlockMesh readBlockMesh(const Case& from);

/// Throws CaseError where another mesher gives the tank another shape.
void refuseOtherMeshers(const Case& from);

} // namespace slosh
