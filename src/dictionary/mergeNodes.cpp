// SPDX-License-Identifier: GPL-3.0-or-later
#include "dictionary/mergeNodes.hpp"

namespace slosh
{

std::shared_ptr<Dictionary::Node>
copyOf(const Dictionary::Node& node, const std::string& name, Dictionary::Node* parent)
{
    auto copy = std::make_shared<Dictionary::Node>(node);
    copy->name = name;
    copy->parent = parent;
    for (auto& entry : copy->entries)
    {
        if (entry.dict)
        {
            entry.dict = copyOf(*entry.dict, name + "/" + entry.key, copy.get());
        }
    }
    return copy;
}

void merge(Dictionary::Node& node, const Dictionary::Node& other, InputMode mode)
{
    node.removed.insert(node.removed.end(), other.removed.begin(), other.removed.end());
    for (const auto& entry : other.entries)
    {
        Dictionary::Entry* present = node.findLiteral(entry.key);
        if (present != nullptr && mode == InputMode::protect)
        {
            continue;
        }
        if (present != nullptr && present->dict && entry.dict && mode == InputMode::merge)
        {
            merge(*present->dict, *entry.dict, mode);
            continue;
        }
        Dictionary::Entry& target = node.add(entry.key, entry.pattern);
        target = entry;
        if (target.dict)
        {
            target.dict->parent = &node;
        }
    }
}

} // namespace slosh
