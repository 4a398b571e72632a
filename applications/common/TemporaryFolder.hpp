// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

namespace slosh
{

/// A folder of its own among the system's temporary ones, removed at the end with all that is in it.
class TemporaryFolder
{
public:
    /// Throws CaseError where none can be made.
    TemporaryFolder();
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
};

} // namespace slosh
