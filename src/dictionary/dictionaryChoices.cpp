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
    throw CaseError(
        "'" + std::string(key) + "' is " + value + placeOf(key) + "; it must be yes or no (on, off, true, false)",
        CaseError::Kind::input
    );
}

bool Dictionary::flagOr(std::string_view key, bool otherwise) const
{
    return has(key) ? flag(key) : otherwise;
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

std::string Dictionary::choiceOr(
    std::string_view key, const std::string& otherwise, const std::vector<std::string>& valid, const std::string& what
) const
{
    return has(key) ? choice(key, valid, what) : otherwise;
}

} // namespace slosh
