// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "BlockMesh.hpp"
#include "Turn.hpp"

#include "case/Case.hpp"
#include "motion/SolidBodyMotion.hpp"

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace slosh
{

/// A tank's motion and the files that say it: theirs byte for byte with its tables and what it includes, or, where it
/// has to be turned or names a cellZone, one that is written.
struct ConvertedMotion
{
    std::shared_ptr<const SolidBodyMotion> motion; ///< in their axes
    std::vector<std::string> copies;               ///< files of theirs that go into ours as they are
    std::string dynamicMeshDict;                   ///< its text where it is written
    std::map<std::string, std::string> tables;     ///< those written, "constant/6DoF.dat": its text

    /// Reads constant/dynamicMeshDict, where there is one. `warnings` names entries that are not used. Throws
    /// CaseError for motions that are no solid body's, that cannot be turned, or of a cellZone that is not the whole
    /// mesh.
    static ConvertedMotion
    read(const Case& from, const BlockMesh& mesh, const Turn& turn, std::vector<std::string>& warnings);
};

} // namespace slosh
