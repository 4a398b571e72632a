// SPDX-License-Identifier: GPL-3.0-or-later
#include "readBlockMesh.hpp"

#include "theirFiles.hpp"

#include <filesystem>
#include <set>

namespace slosh
{

namespace fs = std::filesystem;

namespace
{

/// What to do where there is no blockMeshDict at its place.
std::string adviceFor(const Case& from)
{
    const fs::path system = from.root() / "system";
    if (fs::exists(system / "blockMeshDict.m4"))
    {
        return "; expand it first, in the case:\n    m4 system/blockMeshDict.m4 > system/blockMeshDict";
    }
    if (fs::exists(system / "blockMeshDict.m4.gz"))
    {
        return "; expand it first, in the case:\n    gunzip -c system/blockMeshDict.m4.gz | m4 > system/blockMeshDict";
    }
    std::set<std::string> others;
    for (const auto& item : fs::directory_iterator(system))
    {
        if (const std::string name = item.path().filename().string(); name.find("lockMesh") != std::string::npos)
        {
            others.insert(" system/" + name);
        }
    }
    std::string there;
    for (const auto& file : others)
    {
        there += file;
    }
    return "; expected the blocks of the tank. If Allrun names another file, as in blockMesh -dict <file>, copy that "
           "to "
           "system/blockMeshDict" +
           (there.empty() ? "" : " (found:" + there + ")") + "; if another mesher makes the mesh, write the blocks";
}

} // namespace

BlockMesh readBlockMesh(const Case& from)
{
    for (const std::string file : {"system/blockMeshDict", "constant/polyMesh/blockMeshDict"})
    {
        if (hasFile(from, file))
        {
            return BlockMesh::read(dictionaryIn(from, file));
        }
    }
    throw errorIn("system/blockMeshDict", "file not found" + adviceFor(from));
}

void refuseOtherMeshers(const Case& from)
{
    for (const std::string file :
         {"system/snappyHexMeshDict", "system/extrudeMeshDict", "system/mirrorMeshDict", "system/createBafflesDict"})
    {
        if (fs::exists(from.root() / file))
        {
            throw errorIn(
                file, "the mesher gives the tank another shape than its blocks; remove the file if it is not used"
            );
        }
    }
}

} // namespace slosh
