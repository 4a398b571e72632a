// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Vec.hpp"
#include "case/Case.hpp"

namespace slosh
{

/// constant/polyMesh: one hexahedron, `box`, with a single patch. OpenFOAM's foamToVTK and ParaView's reader need a
/// mesh around a cloud; its particles must lie inside.
void writePolyMesh(const Case& theCase, const BoundingBox& box);

/// system/fvSchemes and system/fvSolution, which foamToVTK and checkMesh insist on: made where they are missing.
void writeMinimalFvFiles(const Case& theCase);

} // namespace slosh
