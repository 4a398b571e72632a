// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace slosh
{

/// All programs, by the manual pages that the build has made of them.
std::vector<std::string> programNames();

} // namespace slosh
