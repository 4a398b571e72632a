// SPDX-License-Identifier: GPL-3.0-or-later
#include "dictionary/etcFolder.hpp"

#include <cstdlib>

namespace slosh
{

std::optional<std::filesystem::path> etcFolder()
{
    namespace fs = std::filesystem;
    if (const char* etc = std::getenv("SLOSH_ETC"))
    {
        return etc;
    }
    std::error_code none; // a system without /proc has the variable only
    for (fs::path folder = fs::read_symlink("/proc/self/exe", none); folder != folder.parent_path();)
    {
        folder = folder.parent_path();
        if (const fs::path etc = folder / "share/sloshsph/etc"; fs::is_directory(etc, none))
        {
            return etc;
        }
    }
    return std::nullopt;
}

} // namespace slosh
