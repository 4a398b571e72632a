// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace slosh
{

/// " (system/blockMeshDict:31)": a place within a sentence.
inline std::string at(const std::string& place)
{
    return " (" + place + ")";
}

} // namespace slosh
