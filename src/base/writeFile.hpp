// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string_view>

namespace slosh
{

/// Writes `content` to `file` as a whole or not at all: to a temporary name beside it, flushed, then renamed. Folders
/// above it are made. Throws CaseError (file and the system's reason: permission, no space left ...) and leaves
/// nothing behind.
void writeFile(const std::filesystem::path& file, std::string_view content);

} // namespace slosh
