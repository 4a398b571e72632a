// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "dictionary/Dictionary.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace slosh
{

/// One of those of a kind that a dictionary can name: a kernel, a motion, a function ... It stands in the source of
/// what it makes; messages, -help and tests are made of the kind's table.
template <class Read>
struct Choice
{
    std::string_view name;      ///< as dictionaries give it
    std::string_view sentence;  ///< what it is, of a function: which quantity in which unit
    Read read;                  ///< makes it: a function, so that a Choice is constant before any code runs
    Keys (*entries)() = noKeys; ///< that go with it in a dictionary
};

/// In the order of the table.
template <class Read>
std::vector<std::string> namesOf(const std::vector<Choice<Read>>& table)
{
    std::vector<std::string> names;
    names.reserve(table.size());
    for (const auto& choice : table)
    {
        names.emplace_back(choice.name);
    }
    return names;
}

/// The table as what an entry can be.
template <class Read>
Options optionsOf(const std::vector<Choice<Read>>& table)
{
    Options options;
    options.reserve(table.size());
    for (const auto& choice : table)
    {
        options.push_back({choice.name, choice.sentence, choice.entries});
    }
    return options;
}

/// The one that is called `name`. Throws std::out_of_range where there is none.
template <class Read>
const Choice<Read>& choiceNamed(const std::vector<Choice<Read>>& table, std::string_view name)
{
    const auto found =
        std::find_if(table.begin(), table.end(), [&](const auto& choice) { return choice.name == name; });
    if (found == table.end())
    {
        throw std::out_of_range("there is no choice '" + std::string(name) + "'");
    }
    return *found;
}

/// The one that the dictionary names at `key`; `what` is how messages call the kind, "motion". Throws CaseError as
/// Dictionary::choice does: a missing key, an unknown name with the nearest and all valid ones.
template <class Read>
const Choice<Read>&
choose(const Dictionary& dict, std::string_view key, const std::vector<Choice<Read>>& table, const std::string& what)
{
    return choiceNamed(table, dict.choice(key, namesOf(table), what));
}
/// The same by a declared entry, whose default may be one of them.
template <class Read>
const Choice<Read>&
choose(const Dictionary& dict, const Key& key, const std::vector<Choice<Read>>& table, const std::string& what)
{
    return choiceNamed(table, dict.choice(key, what));
}

} // namespace slosh
