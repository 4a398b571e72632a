// SPDX-License-Identifier: GPL-3.0-or-later
// Reads of entries that are declared as data.
#include "dictionary/DictionaryNode.hpp"

#include <algorithm>
#include <stdexcept>

namespace slosh
{

namespace
{

/// read(dict, range) of the dictionary, or of the declared default where the entry is left out.
template <class Read>
auto readOrDefault(const Dictionary& dict, const Key& key, const Read& read)
{
    if (dict.has(key.name) || key.otherwise.empty())
    {
        return read(dict, key.range);
    }
    const std::string entry = std::string(key.name) + " " + std::string(key.otherwise) + ";";
    return read(Dictionary::parse(entry, "the default"), anyNumber);
}

} // namespace

double Dictionary::scalar(const Key& key) const
{
    return readOrDefault(
        *this, key, [&](const Dictionary& dict, const Range& range) { return dict.scalar(key.name, key.unit, range); }
    );
}

long Dictionary::label(const Key& key) const
{
    return readOrDefault(
        *this, key, [&](const Dictionary& dict, const Range& range) { return dict.label(key.name, range); }
    );
}

bool Dictionary::flag(const Key& key) const
{
    return readOrDefault(*this, key, [&](const Dictionary& dict, const Range&) { return dict.flag(key.name); });
}

std::string Dictionary::word(const Key& key) const
{
    return readOrDefault(*this, key, [&](const Dictionary& dict, const Range&) { return dict.word(key.name); });
}

std::string Dictionary::choice(const Key& key, const std::string& what) const
{
    std::vector<std::string> valid;
    for (const Option& option : key.options())
    {
        valid.emplace_back(option.name);
    }
    return readOrDefault(
        *this, key, [&](const Dictionary& dict, const Range&) { return dict.choice(key.name, valid, what); }
    );
}

Vec Dictionary::vector(const Key& key) const
{
    return readOrDefault(
        *this, key, [&](const Dictionary& dict, const Range&) { return dict.vector(key.name, key.unit); }
    );
}

std::vector<double> Dictionary::scalars(const Key& key) const
{
    return readOrDefault(
        *this, key, [&](const Dictionary& dict, const Range& range) { return dict.scalars(key.name, key.unit, range); }
    );
}

std::vector<Vec> Dictionary::vectors(const Key& key) const
{
    return readOrDefault(
        *this, key, [&](const Dictionary& dict, const Range&) { return dict.vectors(key.name, key.unit); }
    );
}

std::vector<Vec2> Dictionary::planePoints(const Key& key) const
{
    return readOrDefault(
        *this, key, [&](const Dictionary& dict, const Range&) { return dict.planePoints(key.name, key.unit); }
    );
}

std::vector<std::string> Dictionary::words(const Key& key) const
{
    return readOrDefault(*this, key, [&](const Dictionary& dict, const Range&) { return dict.words(key.name); });
}

/// Throws std::logic_error where a reader has asked for an entry that is not among `keys`.
static void requireDeclared(const Dictionary& dict, const std::set<std::string, std::less<>>& asked, const Keys& keys)
{
    for (const std::string& name : asked)
    {
        if (std::none_of(keys.begin(), keys.end(), [&](const Key& key) { return key.anyName || key.name == name; }))
        {
            throw std::logic_error("'" + name + "' of " + dict.name() + " is read and is not declared");
        }
    }
}

static std::vector<std::string> namesOf(const Keys& keys)
{
    std::vector<std::string> names;
    for (const Key& key : keys)
    {
        if (!key.anyName)
        {
            names.emplace_back(key.name);
        }
    }
    return names;
}

/// `keys` and those of the options that the dictionary takes.
static Keys takenOf(const Dictionary& dict, const Keys& keys)
{
    Keys taken;
    for (const Key& key : keys)
    {
        taken.push_back(key);
        const std::string word = dict.has(key) ? dict.textAt(key) : std::string(key.otherwise);
        for (const Option& option : key.options())
        {
            if (option.name == word)
            {
                taken = joined(std::move(taken), takenOf(dict, option.entries()));
            }
        }
    }
    return taken;
}

void Dictionary::refuseUnknown(const Keys& keys) const
{
    const Keys all = withThoseOfOptions(keys);
    requireDeclared(*this, node_->asked, all);
    allow(namesOf(all));
    refuseUnknown();
}

void Dictionary::refuseIdle(const Keys& keys) const
{
    requireDeclared(*this, node_->asked, withThoseOfOptions(keys));
    allow(namesOf(takenOf(*this, keys)));
    refuseUnknown();
}

} // namespace slosh
