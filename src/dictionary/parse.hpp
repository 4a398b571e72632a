// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "dictionary/DictionaryNode.hpp"

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

namespace slosh
{

/// Turns text into entries, macros and directives resolved: $macro, -$macro, #include, #includeIfPresent, #includeEtc
/// (in $SLOSH_ETC), #includeFunc (in system/), #inputMode, #remove, #eval, #calc, ${{ expression }}. Repeated
/// sub-dictionaries are merged, repeated entries overwritten (OpenFOAM's default). `name`: how messages call the file;
/// `folder`: where #include looks. Throws CaseError with file and line.
void parseInto(
    Dictionary::Node& root, std::string_view text, const std::string& name, const std::filesystem::path& folder
);

} // namespace slosh
