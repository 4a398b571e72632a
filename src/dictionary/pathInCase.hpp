// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace slosh
{

/// The rest of a path that begins with $FOAM_CASE, ${FOAM_CASE}, <case>, <constant> or <system>, from the case on:
/// "constant/waves"; nothing for any other path.
std::optional<std::string> pathInCase(const std::string& path);

/// The case that a file in `folder` is of: the folder above the constant or system that `folder` is or lies in; where
/// there is none, the folder above `folder`.
std::filesystem::path caseOf(const std::filesystem::path& folder);

} // namespace slosh
