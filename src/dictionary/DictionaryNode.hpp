// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "dictionary/Dictionary.hpp"

#include <functional>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

namespace slosh
{

/// A keyword with its value or its sub-dictionary.
struct Dictionary::Entry
{
    std::string key;
    bool pattern = false; ///< a regular expression
    std::string file;
    int line = 0;
    std::vector<Token> tokens;  ///< the value, or
    std::shared_ptr<Node> dict; ///< a sub-dictionary
    mutable bool read = false;
    mutable bool ignored = false;  ///< others' business
    mutable bool expanded = false; ///< a macro stands for it
    bool isDefault = false;        ///< set by setDefault()
};

/// What a Dictionary holds: entries in the order of the file. Only src/dictionary sees it.
struct Dictionary::Node
{
    std::string name; ///< file and path inside
    std::string file;
    int line = 0;
    int lastLine = 0;
    Node* parent = nullptr; ///< while it is parsed: where macros are looked up
    std::vector<Entry> entries;
    std::map<std::string, std::size_t, std::less<>> index; ///< of literal keys
    mutable std::set<std::string, std::less<>> asked;      ///< keys a reader knows
    std::vector<std::string> removed; ///< by #remove: text() says it again, for entries that go behind a file's own

    /// The entry of that key: literal first, else the last pattern that matches; null where there is none.
    Entry* find(std::string_view key);
    /// Literal only.
    Entry* findLiteral(std::string_view key);
    Entry& add(const std::string& key, bool pattern);
    void remove(const std::string& key);
};

} // namespace slosh
