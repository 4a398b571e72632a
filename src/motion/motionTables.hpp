// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace slosh
{

class Dictionary;

/// Where a table named in a dictionary lies: "$FOAM_CASE/...", "<case>/...", "<constant>/...", "<system>/...", from the
/// root, or from the case.
std::string tablePath(const std::string& name, const std::string& caseFolder);

/// The tables that a dynamicMeshDict names, at any depth (timeDataFileName, and file of a Function1), by their paths.
std::vector<std::string> motionTables(const Dictionary& dynamicMeshDict, const std::string& caseFolder);

} // namespace slosh
