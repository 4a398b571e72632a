// SPDX-License-Identifier: GPL-3.0-or-later
#include "ConvertedMotion.hpp"

#include "theirFiles.hpp"
#include "turnedMotion.hpp"

#include "motion/motionTables.hpp"

#include <algorithm>
#include <set>

namespace slosh
{

namespace
{

namespace fs = std::filesystem;

const std::string motionFile = "constant/dynamicMeshDict";

/// A zone that all blocks of the mesh are in is the mesh: takes it out. Whether there was one.
bool removeZoneOfAll(const Dictionary& dict, const BlockMesh& mesh)
{
    std::optional<Dictionary> motion = motionDictionary(dict);
    if (!motion || !motion->has("cellZone"))
    {
        return false;
    }
    const std::string zone = motion->word("cellZone");
    const bool isAll =
        std::all_of(mesh.zones.begin(), mesh.zones.end(), [&](const std::string& other) { return other == zone; });
    if (isAll)
    {
        motion->set("cellZone", "none");
    }
    return isAll;
}

/// Files of theirs, relative to the case: ours has them at the same places.
std::vector<std::string> toCopy(const std::set<std::string>& files, const fs::path& root)
{
    std::vector<std::string> copies;
    for (const auto& file : files)
    {
        const std::string plain = fs::path(file).lexically_normal().string();
        if (plain.rfind("..", 0) == 0)
        {
            throw errorIn(motionFile, "the file \"" + file + "\" is outside the case; expected a file in it");
        }
        copies.push_back(fs::exists(root / plain) ? plain : plain + ".gz");
    }
    return copies;
}

std::set<std::string> tablesOf(const Dictionary& dict, const fs::path& root)
{
    std::set<std::string> files;
    for (const auto& file : motionTables(dict, root.string()))
    {
        files.insert(fs::path(file).lexically_relative(root).string());
    }
    return files;
}

} // namespace

ConvertedMotion
ConvertedMotion::read(const Case& from, const BlockMesh& mesh, const Turn& turn, std::vector<std::string>& warnings)
{
    ConvertedMotion converted;
    if (!hasFile(from, motionFile))
    {
        converted.motion = SolidBodyMotion::stationary();
        return converted;
    }
    const fs::path& root = from.root();
    const Dictionary dict = dictionaryIn(from, motionFile);
    const bool hadZone = removeZoneOfAll(dict, mesh);
    converted.motion = SolidBodyMotion::read(dict, root.string());
    for (const auto& entry : dict.unusedEntries())
    {
        warnings.push_back(entry + " is not used");
    }
    if (turn.isNone() && !hadZone)
    {
        std::set<std::string> files = dict.files();
        files.insert(motionFile);
        files.merge(tablesOf(dict, root));
        converted.copies = toCopy(files, root);
        return converted;
    }
    if (turn.isNone())
    {
        converted.dynamicMeshDict = dict.text();
        converted.copies = toCopy(tablesOf(dict, root), root);
        return converted;
    }
    if (converted.motion->isStationary())
    {
        return converted;
    }
    const TurnedMotion turned = turnedMotion(*motionDictionary(dict), turn, root.string());
    converted.dynamicMeshDict = turned.dynamicMeshDict.text();
    converted.tables = turned.tables;
    std::set<std::string> tables = tablesOf(turned.dynamicMeshDict, root);
    std::erase_if(tables, [&](const std::string& file) { return turned.tables.count(file) > 0; });
    converted.copies = toCopy(tables, root);
    return converted;
}

} // namespace slosh
