// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

namespace slosh
{

/// The bytes of a file, or, where it is absent and a file of its name and .gz is there, what that holds, as OpenFOAM
/// reads its files. `name`: how messages call it. Throws CaseError: neither is there, or it cannot be read.
std::string readText(const std::filesystem::path& file, const std::string& name);

/// Whether readText() finds it.
bool isThere(const std::filesystem::path& file);

} // namespace slosh
