// SPDX-License-Identifier: GPL-3.0-or-later
#include "readBlockMesh.hpp"

#include <filesystem>

namespace slosh
{

namespace fs = std::filesystem;

BlockMesh readBlockMesh(const Case& from)
{
    const auto exists = [&](const std::string& file) { return fs::exists(from.root() / file); };
    for (const std::string file : {"system/blockMeshDict", "constant/polyMesh/blockMeshDict"})
    {
        if (exists(file) || exists(file + ".gz"))
        {
            return BlockMesh::read(from.dictionary(file));
        }
    }
    std::string hint;
    if (exists("system/blockMeshDict.m4"))
    {
        hint = "m4 system/blockMeshDict.m4 > system/blockMeshDict";
    }
    else if (exists("system/blockMeshDict.m4.gz"))
    {
        hint = "gunzip -c system/blockMeshDict.m4.gz | m4 > system/blockMeshDict";
    }
    throw CaseError(
        "cannot find file \"system/blockMeshDict\"" +
            (hint.empty() ? "" : "; it has to be expanded first: in the case,\n    " + hint),
        CaseError::Kind::input
    );
}

void refuseOtherMeshers(const Case& from)
{
    for (const std::string file :
         {"system/snappyHexMeshDict", "system/extrudeMeshDict", "system/mirrorMeshDict", "system/createBafflesDict"})
    {
        if (fs::exists(from.root() / file))
        {
            throw CaseError(
                "the tank cannot be converted: " + file +
                    " gives it another shape than its blocks; remove that file where it is not used",
                CaseError::Kind::input
            );
        }
    }
}

} // namespace slosh
