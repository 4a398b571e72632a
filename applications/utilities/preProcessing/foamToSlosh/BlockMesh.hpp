// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "dictionary/Dictionary.hpp"

#include <array>
#include <string>
#include <vector>

namespace slosh
{

struct Turn;

/// What blockMesh makes a mesh of, as far as it says where the walls are: corners and blocks; cells and their grading
/// say nothing of that.
struct BlockMesh
{
    using Face = std::vector<int>; ///< labels of its corners, in their order round it

    struct Patch
    {
        std::string name, type;
        std::vector<Face> faces;
        std::string place; ///< "system/blockMeshDict:31"
    };

    std::string file;
    std::vector<Vec> vertices; ///< scaled, [m]
    std::vector<std::array<int, 8>> blocks;
    std::vector<std::string> zones; ///< the cellZone of each block, "" where it is in none
    std::vector<Patch> patches;
    std::string defaultName = "defaultFaces", defaultType = "empty"; ///< of the faces that no patch names

    /// The six faces of a block, in OpenFOAM's order: x-, x+, y-, y+, z-, z+.
    static std::vector<Face> facesOf(const std::array<int, 8>& block);

    /// Reads system/blockMeshDict: patches in the new form (boundary) and the old one. Throws CaseError naming all that
    /// has no straight edges and flat faces between corners that are given: projections, arcs, splines, merged patches;
    /// and what blockMesh refuses as well.
    static BlockMesh read(const Dictionary& blockMeshDict);

    BlockMesh turned(const Turn& turn) const;
};

} // namespace slosh
