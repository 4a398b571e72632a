// SPDX-License-Identifier: GPL-3.0-or-later
#include "boundaries.hpp"

#include "theirFiles.hpp"

#include <algorithm>

namespace slosh
{

namespace
{

/// The condition of U at a patch and the file that has it; empty where it cannot be read.
std::pair<std::string, std::string> conditionOf(const Case& theCase, const std::string& patch)
{
    for (const std::string file : {"0/U", "0/U.orig", "0.orig/U"})
    {
        if (!hasFile(theCase, file))
        {
            continue;
        }
        try
        {
            const Dictionary condition = dictionaryIn(theCase, file).dict("boundaryField").dict(patch);
            const std::string type = condition.word("type");
            const auto isZero = [&]
            {
                const auto& value = condition.tokens("value");
                return std::all_of(
                    value.begin(), value.end(),
                    [](const Token& token) { return token.kind != Token::Kind::number || token.number == 0; }
                );
            };
            return {type == "fixedValue" && isZero() ? "noSlip" : type, file};
        }
        catch (const CaseError&)
        {
            return {"", file}; // it may include what only OpenFOAM finds
        }
    }
    return {"", "0/U"};
}

} // namespace

void warnOfPatches(const Case& theCase, const BlockMesh& mesh, std::vector<std::string>& warnings)
{
    for (const auto& patch : mesh.patches)
    {
        if (patch.type == "wall" || patch.type == "empty" || patch.faces.empty())
        {
            continue;
        }
        const std::string here = "; here it is a wall, as is the whole tank";
        if (patch.type != "patch")
        {
            warnings.push_back(patch.place + ": the patch '" + patch.name + "' is of type " + patch.type + here);
            continue;
        }
        const auto [condition, file] = conditionOf(theCase, patch.name);
        const std::vector<std::string> walls = {"movingWallVelocity", "noSlip", "slip", "partialSlip"};
        if (std::find(walls.begin(), walls.end(), condition) == walls.end())
        {
            warnings.push_back(
                patch.place + ": the patch '" + patch.name + "' " +
                (condition.empty() ? "may be open (no condition found in " + file + ")"
                                   : "is open (" + condition + " in " + file + ")") +
                here
            );
        }
    }
}

} // namespace slosh
