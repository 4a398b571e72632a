// SPDX-License-Identifier: GPL-3.0-or-later
// Writing a Dictionary.
#include "dictionary/Dictionary.hpp"

#include "base/numberText.hpp"
#include "base/pointText.hpp"
#include "dictionary/DictionaryNode.hpp"
#include "dictionary/tokenize.hpp"

namespace slosh
{

namespace
{

std::string quoted(const std::string& text)
{
    std::string out = "\"";
    for (const char c : text)
    {
        out += c == '"' ? std::string("\\\"") : std::string(1, c);
    }
    return out + "\"";
}

void append(std::string& out, const Dictionary::Node& node, int indent)
{
    const std::string blanks(static_cast<std::size_t>(indent), ' ');
    for (const auto& key : node.removed)
    {
        out += blanks + "#remove         " + quoted(key) + "\n";
    }
    for (const auto& entry : node.entries)
    {
        if (entry.key == "FoamFile")
        {
            continue;
        }
        const std::string key = entry.pattern ? quoted(entry.key) : entry.key;
        if (entry.dict)
        {
            out += blanks + key + "\n" + blanks + "{\n";
            append(out, *entry.dict, indent + 4);
            out += blanks + "}\n";
            continue;
        }
        out += blanks + key + (key.size() < 15 ? std::string(16 - key.size(), ' ') : " ");
        for (std::size_t k = 0; k < entry.tokens.size(); ++k)
        {
            const Token& token = entry.tokens[k];
            const bool glued =
                k == 0 || entry.tokens[k - 1].is('(') || entry.tokens[k - 1].is('[') || token.is(')') || token.is(']');
            out += (glued ? "" : " ") + (token.kind == Token::Kind::string ? quoted(token.text) : token.text);
        }
        out += ";\n";
    }
}

} // namespace

void Dictionary::set(std::string_view key, std::string_view value)
{
    auto& entry = node_->add(std::string(key), false);
    entry.dict = nullptr;
    entry.tokens = tokenize(value, name());
}

void Dictionary::set(std::string_view key, double value)
{
    set(key, std::string_view(numberText(value)));
}

void Dictionary::set(std::string_view key, long value)
{
    set(key, std::string_view(std::to_string(value)));
}

void Dictionary::set(std::string_view key, const Vec& value)
{
    set(key, std::string_view(exactText(value)));
}

void Dictionary::set(std::string_view key, const Dictionary& value)
{
    auto& entry = node_->add(std::string(key), false);
    entry.tokens.clear();
    entry.dict = value.node_;
}

bool Dictionary::setDefault(std::string_view path, std::string_view value, const std::string& origin)
{
    if (const auto slash = path.find('/'); slash != std::string_view::npos)
    {
        const std::string key(path.substr(0, slash));
        Entry* inner = node_->find(key);
        if (inner != nullptr && !inner->dict)
        {
            return false; // the reader will say that it must be a dictionary
        }
        if (inner == nullptr)
        {
            set(key, Dictionary(name() + "/" + key));
            inner = node_->findLiteral(key);
            inner->file = origin;
            inner->ignored = true;
            inner->isDefault = true;
        }
        return Dictionary(inner->dict).setDefault(path.substr(slash + 1), value, origin);
    }
    if (node_->find(path) != nullptr)
    {
        return false;
    }
    set(path, value);
    Entry& entry = *node_->findLiteral(path);
    entry.file = origin;
    entry.ignored = true;
    entry.isDefault = true;
    return true;
}

bool Dictionary::isDefault(std::string_view path) const
{
    const auto slash = path.find('/');
    const Entry* entry = node_->find(path.substr(0, slash));
    if (entry == nullptr || slash == std::string_view::npos)
    {
        return entry != nullptr && entry->isDefault;
    }
    return entry->dict && Dictionary(entry->dict).isDefault(path.substr(slash + 1));
}

std::string Dictionary::text() const
{
    std::string out;
    append(out, *node_, 0);
    return out;
}

} // namespace slosh
