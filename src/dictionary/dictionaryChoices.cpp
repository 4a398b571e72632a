// SPDX-License-Identifier: GPL-3.0-or-later
// Reads of words that must be one of some.
#include "dictionary/Dictionary.hpp"

#include <algorithm>

namespace slosh
{

bool Dictionary::flag(std::string_view key) const
{
    const std::string value = word(key);
    for (const auto* yes : {"yes", "on", "true", "y", "t"})
    {
        if (value == yes)
        {
            return true;
        }
    }
    for (const auto* no : {"no", "off", "false", "n", "f", "none"})
    {
        if (value == no)
        {
            return false;
        }
    }
    throw errorAt(key, "is " + value + "; expected yes or no (on, off, true, false)");
}

std::string
Dictionary::choice(std::string_view key, const std::vector<std::string>& valid, const std::string& what) const
{
    const std::string value = word(key);
    if (std::find(valid.begin(), valid.end(), value) == valid.end())
    {
        throw unknownName(what, value, placeOf(key), valid);
    }
    return value;
}

} // namespace slosh
