// SPDX-License-Identifier: GPL-3.0-or-later
#include "programNames.hpp"

#include <algorithm>
#include <filesystem>

namespace slosh
{

std::vector<std::string> programNames()
{
    std::vector<std::string> names;
    for (const auto& page : std::filesystem::directory_iterator(SLOSH_BIN "/../share/man/man1"))
    {
        names.push_back(page.path().stem().string());
    }
    std::sort(names.begin(), names.end());
    return names;
}

} // namespace slosh
