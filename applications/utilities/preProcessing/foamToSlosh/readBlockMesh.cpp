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
        return "; it has to be expanded first: in the case,\n    m4 system/blockMeshDict.m4 > system/blockMeshDict";
    }
    if (fs::exists(system / "blockMeshDict.m4.gz"))
    {
        return "; it has to be expanded first: in the case,\n    gunzip -c system/blockMeshDict.m4.gz | m4 > "
               "system/blockMeshDict";
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
    return ": only tanks that blockMesh makes are converted. Where Allrun gives it a file of another name, blockMesh "
           "-dict "
           "<file>, copy that to system/blockMeshDict" +
           (there.empty() ? "" : " (there is" + there + ")") +
           "; where another mesher makes the mesh, write the tank's blocks there";
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
    throw CaseError("cannot find file \"system/blockMeshDict\"" + adviceFor(from), CaseError::Kind::input);
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
