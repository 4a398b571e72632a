// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "case/Case.hpp"
#include "dictionary/readText.hpp"

#include <string>

namespace slosh
{

/// Whether a case has the file "constant/g", or constant/g.gz.
inline bool hasFile(const Case& theirs, const std::string& file)
{
    return isThere(theirs.root() / file);
}

/// One of OpenFOAM's dictionaries, with none of our schemes' entries. Throws CaseError where it is missing.
inline Dictionary dictionaryIn(const Case& theirs, const std::string& file)
{
    return Dictionary::read(theirs.root() / file, file);
}

} // namespace slosh
