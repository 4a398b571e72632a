// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "dictionary/Range.hpp"
#include "dictionary/Unit.hpp"

#include <string_view>
#include <vector>

namespace slosh
{

struct Key;
using Keys = std::vector<Key>;

Keys noKeys();

/// A word that an entry can be, and the entries that go with it.
struct Option
{
    std::string_view name{};
    std::string_view sentence{};
    Keys (*entries)() = noKeys;
};
using Options = std::vector<Option>;
Options noOptions();

/// An entry of a user's dictionary as data, declared beside what reads it. Its reading (Dictionary), 'did you mean' and
/// the annotated dictionaries (AnnotatedDictionary) are made of it. Text fields are as a dictionary has them:
///     constexpr Key delta{.name = "delta", .otherwise = "0.1", .range = positive, .sentence = "more smooths more"};
///     const double value = dict.scalar(delta);
struct Key
{
    std::string_view name{};
    std::string_view otherwise{}; ///< its value where it is left out; empty: it has none
    std::string_view leftOut{};   ///< what holds where it is left out and is no value, in words
    std::string_view example{};   ///< value in the annotated dictionary; empty: `otherwise`
    Unit unit = unit::none;
    Range range = anyNumber; ///< of a number; `otherwise` may lie outside
    std::string_view sentence{};
    Options (*options)() = noOptions; ///< of a word: what it can be
    Keys (*entries)() = nullptr;      ///< of a dictionary: what can stand in it
    bool anyName = false;             ///< the name is the user's: `name` is an example
    bool eachOption = false;          ///< of such a dictionary: an example for each option of its first entry
    bool alternative = false;         ///< a comment in the annotated dictionary: in place of another entry, or seldom
    bool noEffect = false;            ///< OpenFOAM's or another program's, accepted and not read

    constexpr operator std::string_view() const { return name; }
};

/// The same with another example.
Key withExample(Key key, std::string_view example);

/// `keys` and the entries of all their options: every entry that is valid in one dictionary.
Keys withThoseOfOptions(const Keys& keys);

/// `first` with the entries of `more` behind.
Keys joined(Keys first, const Keys& more);

/// Names that are accepted and not read.
Keys withoutEffect(const std::vector<std::string_view>& names);

} // namespace slosh
