// SPDX-License-Identifier: GPL-3.0-or-later
#include "dictionary/Dictionary.hpp"

#include "dictionary/DictionaryNode.hpp"
#include "dictionary/parse.hpp"
#include "dictionary/readText.hpp"

#include <algorithm>
#include <regex>

namespace slosh
{

using Node = Dictionary::Node;

Dictionary::Entry* Node::findLiteral(std::string_view key)
{
    const auto found = index.find(key);
    return found == index.end() ? nullptr : &entries[found->second];
}

Dictionary::Entry* Node::find(std::string_view key)
{
    if (Entry* literal = findLiteral(key); literal != nullptr)
    {
        return literal;
    }
    for (auto entry = entries.rbegin(); entry != entries.rend(); ++entry)
    {
        if (entry->pattern && std::regex_match(std::string(key), std::regex(entry->key)))
        {
            return &*entry;
        }
    }
    return nullptr;
}

Dictionary::Entry& Node::add(const std::string& key, bool pattern)
{
    const auto [place, isNew] = index.try_emplace(key, entries.size());
    if (isNew)
    {
        entries.emplace_back();
        entries.back().key = key;
    }
    Entry& entry = entries[place->second];
    entry.pattern = pattern;
    return entry;
}

void Node::remove(const std::string& key)
{
    removed.push_back(key);
    const auto found = index.find(key);
    if (found == index.end())
    {
        return;
    }
    entries.erase(entries.begin() + static_cast<std::ptrdiff_t>(found->second));
    index.clear();
    for (std::size_t k = 0; k < entries.size(); ++k)
    {
        index[entries[k].key] = k;
    }
}

Dictionary::Dictionary(std::string name) : node_(std::make_shared<Node>())
{
    node_->name = name;
    node_->file = std::move(name);
}

Dictionary::Dictionary(std::shared_ptr<Node> node) : node_(std::move(node)) {}

Dictionary Dictionary::read(const std::filesystem::path& file, const std::string& name)
{
    Dictionary dict(name);
    parseInto(*dict.node_, readText(file, name), name, file.parent_path());
    return dict;
}

Dictionary Dictionary::parse(std::string_view text, const std::string& name, const std::filesystem::path& folder)
{
    Dictionary dict(name);
    parseInto(*dict.node_, text, name, folder);
    return dict;
}

const std::string& Dictionary::name() const
{
    return node_->name;
}

int Dictionary::line() const
{
    return node_->line;
}

std::vector<std::string> Dictionary::keys() const
{
    std::vector<std::string> keys;
    for (const auto& entry : node_->entries)
    {
        if (entry.key != "FoamFile")
        {
            keys.push_back(entry.key);
        }
    }
    return keys;
}

bool Dictionary::has(std::string_view key) const
{
    node_->asked.emplace(key);
    return node_->find(key) != nullptr;
}

bool Dictionary::isDict(std::string_view key) const
{
    node_->asked.emplace(key);
    const auto* entry = node_->find(key);
    return entry != nullptr && entry->dict != nullptr;
}

const Dictionary::Entry& Dictionary::entry(std::string_view key) const
{
    node_->asked.emplace(key);
    const auto* entry = node_->find(key);
    if (entry == nullptr)
    {
        std::string message = "entry '" + std::string(key) + "' not found in dictionary \"" + name() + "\" (lines " +
                              std::to_string(std::max(1, node_->line)) + " to " + std::to_string(node_->lastLine) + ")";
        std::vector<std::string> unread;
        for (const auto& other : node_->entries)
        {
            if (node_->asked.count(other.key) == 0 && other.key != "FoamFile")
            {
                unread.push_back(other.key);
            }
        }
        if (const auto nearest = nearestName(std::string(key), unread); !nearest.empty())
        {
            message += "; did you mean '" + nearest + "' (" + placeOf(nearest) + ")?";
        }
        throw errorIn(placeIn(node_->file, node_->line), message);
    }
    entry->read = true;
    return *entry;
}

const std::vector<Token>& Dictionary::tokens(std::string_view key) const
{
    const auto& found = entry(key);
    if (found.dict)
    {
        throw errorAt(key, "is a dictionary; expected a value");
    }
    return found.tokens;
}

Dictionary Dictionary::dict(std::string_view key) const
{
    const auto& found = entry(key);
    if (!found.dict)
    {
        throw errorAt(key, "is a value; expected a dictionary { ... }");
    }
    return Dictionary(found.dict);
}

Dictionary Dictionary::dictOr(std::string_view key) const
{
    if (has(key))
    {
        return dict(key);
    }
    return Dictionary(name() + "/" + std::string(key));
}

void Dictionary::allow(const std::vector<std::string>& keys) const
{
    node_->asked.insert(keys.begin(), keys.end());
}

void Dictionary::ignore(const std::vector<std::string>& keys) const
{
    allow(keys);
    for (const auto& key : keys)
    {
        if (const auto* entry = node_->find(key))
        {
            entry->ignored = true;
        }
    }
}

void Dictionary::refuseUnknown() const
{
    const auto& asked = node_->asked;
    for (const auto& entry : node_->entries)
    {
        if (entry.key == "FoamFile" || entry.read || entry.expanded || asked.count(entry.key) != 0)
        {
            continue;
        }
        if (entry.pattern)
        {
            const std::regex expression(entry.key);
            if (std::any_of(
                    asked.begin(), asked.end(),
                    [&](const std::string& key) { return std::regex_match(key, expression); }
                ))
            {
                continue;
            }
        }
        throw unknownName("keyword", entry.key, placeIn(entry.file, entry.line), {asked.begin(), asked.end()});
    }
}

std::vector<std::string> Dictionary::unusedEntries() const
{
    std::vector<std::string> unused;
    for (const auto& entry : node_->entries)
    {
        if (entry.key == "FoamFile" || entry.ignored)
        {
            continue;
        }
        if (!entry.read && !entry.expanded)
        {
            unused.push_back(placeIn(entry.file, entry.line) + ": " + entry.key);
        }
        else if (entry.read && entry.dict)
        {
            const auto inner = Dictionary(entry.dict).unusedEntries();
            unused.insert(unused.end(), inner.begin(), inner.end());
        }
    }
    return unused;
}

std::set<std::string> Dictionary::files() const
{
    std::set<std::string> files = {node_->file};
    for (const auto& entry : node_->entries)
    {
        files.insert(entry.file);
        if (entry.dict)
        {
            files.merge(Dictionary(entry.dict).files());
        }
    }
    return files;
}

std::string Dictionary::placeOf(std::string_view key) const
{
    if (const auto slash = key.find('/'); slash != std::string_view::npos)
    {
        const auto* outer = node_->find(key.substr(0, slash));
        if (outer != nullptr && outer->dict)
        {
            return Dictionary(outer->dict).placeOf(key.substr(slash + 1));
        }
    }
    const auto* entry = node_->find(key);
    return entry == nullptr ? placeIn(node_->file, node_->line) : placeIn(entry->file, entry->line);
}

CaseError Dictionary::errorAt(std::string_view key, const std::string& message) const
{
    return errorIn(placeOf(key), std::string(key) + " " + message);
}

std::string Dictionary::textAt(std::string_view path) const
{
    const auto slash = path.find('/');
    const auto* entry = node_->find(path.substr(0, slash));
    if (entry == nullptr)
    {
        return "";
    }
    if (slash != std::string_view::npos)
    {
        return entry->dict ? Dictionary(entry->dict).textAt(path.substr(slash + 1)) : "";
    }
    std::string text;
    for (const Token& token : entry->tokens)
    {
        text += (text.empty() ? "" : " ") + token.text;
    }
    return text;
}

} // namespace slosh
