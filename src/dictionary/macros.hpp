// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "dictionary/DictionaryNode.hpp"

#include <string>

namespace slosh
{

/// The name in $name, ${name} and -$name.
std::string macroName(const std::string& text);

/// What $name stands for where `start` is the dictionary around it: name is looked for there, else in the dictionaries
/// around; :a.b from the top, .name there alone, ..name one level up, a.b inside a. Null where there is none. It
/// counts as expanded.
const Dictionary::Entry* lookUp(Dictionary::Node& start, std::string name);

} // namespace slosh
