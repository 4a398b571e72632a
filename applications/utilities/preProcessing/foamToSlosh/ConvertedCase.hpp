// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "case/Case.hpp"

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace slosh
{

/// Our case of one of interFoam: what stands in its files, and what is to be said of it.
struct ConvertedCase
{
    std::map<std::string, std::string> files; ///< "constant/tankProperties": its text
    std::vector<std::string> copies;          ///< files of theirs that go into ours as they are
    std::vector<std::string> facts, warnings; ///< for the log

    /// Reads system/blockMeshDict, setFieldsDict, controlDict, functions, constant/g, transportProperties or
    /// phaseProperties, dynamicMeshDict. With no spacing, [m], one is taken that gives 5000 particles of liquid in 2D,
    /// 50000 in 3D. Throws CaseError where the tank, the liquid, the motion or gravity cannot be converted; the
    /// warnings are those found so far then.
    void convert(const Case& interFoamCase, std::optional<double> spacing);

    /// Writes all of it, or nothing. Throws CaseError where the folder is not empty.
    void write(const Case& interFoamCase, const std::filesystem::path& folder) const;

private:
    void convertFiles(const Case& interFoamCase, std::optional<double> spacing);
};

} // namespace slosh
