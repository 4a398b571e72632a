// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>

namespace slosh
{

/// Where #includeEtc looks: $SLOSH_ETC, else share/sloshsph/etc in the nearest folder above this program that has it,
/// as programs that were installed find it. Nothing where there is neither.
std::optional<std::filesystem::path> etcFolder();

} // namespace slosh
