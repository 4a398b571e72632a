// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "dictionary/Key.hpp"

#include <string>

namespace slosh
{

/// What can stand in a dictionary of a case, to be copied and edited: each entry with its unit, range and default, as
/// it is declared. etc/annotated is made of it, by etc/annotate.
struct AnnotatedDictionary
{
    std::string path; ///< in the case, "system/sphSchemes"
    std::string text; ///< what the dictionary is for, in paragraphs
    Keys (*keys)();
    std::string foamClass = "dictionary";

    /// The file, as OpenFOAM lays dictionaries out:
    ///     delta           0.1;                // > 0, default 0.1: more smooths more
    /// Entries of options that the example does not take, and alternatives, stand in comments.
    std::string file() const;
};

/// "[m], > 0, default 1: ..."
std::string describe(const Key& key);

} // namespace slosh
