// SPDX-License-Identifier: GPL-3.0-or-later
#include "dictionary/macros.hpp"

namespace slosh
{

namespace
{

const Dictionary::Entry* inside(Dictionary::Node& node, const std::string& name)
{
    if (Dictionary::Entry* whole = node.find(name))
    {
        return whole;
    }
    const auto dot = name.find('.');
    if (dot == std::string::npos)
    {
        return nullptr;
    }
    const Dictionary::Entry* outer = node.find(name.substr(0, dot));
    return outer != nullptr && outer->dict ? inside(*outer->dict, name.substr(dot + 1)) : nullptr;
}

} // namespace

std::string macroName(const std::string& text)
{
    const std::string name = text.substr(text.find('$') + 1);
    return name.size() > 1 && name[0] == '{' ? name.substr(1, name.size() - 2) : name;
}

const Dictionary::Entry* lookUp(Dictionary::Node& start, std::string name)
{
    Dictionary::Node* node = &start;
    bool everywhere = true;
    if (!name.empty() && name[0] == ':')
    {
        while (node->parent != nullptr)
        {
            node = node->parent;
        }
        name.erase(0, 1);
        everywhere = false;
    }
    else if (!name.empty() && name[0] == '.')
    {
        name.erase(0, 1);
        everywhere = false;
        while (!name.empty() && name[0] == '.' && node->parent != nullptr)
        {
            node = node->parent;
            name.erase(0, 1);
        }
    }
    for (; node != nullptr; node = everywhere ? node->parent : nullptr)
    {
        if (const Dictionary::Entry* found = inside(*node, name))
        {
            found->expanded = true;
            return found;
        }
    }
    return nullptr;
}

} // namespace slosh
