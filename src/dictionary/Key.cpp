// SPDX-License-Identifier: GPL-3.0-or-later
#include "dictionary/Key.hpp"

namespace slosh
{

Key withExample(Key key, std::string_view example)
{
    key.example = example;
    return key;
}

Keys noKeys()
{
    return {};
}

Options noOptions()
{
    return {};
}

Keys withThoseOfOptions(const Keys& keys)
{
    Keys all;
    for (const Key& key : keys)
    {
        all.push_back(key);
        for (const Option& option : key.options())
        {
            all = joined(std::move(all), withThoseOfOptions(option.entries()));
        }
    }
    return all;
}

Keys joined(Keys first, const Keys& more)
{
    first.insert(first.end(), more.begin(), more.end());
    return first;
}

Keys withoutEffect(const std::vector<std::string_view>& names)
{
    Keys keys;
    keys.reserve(names.size());
    for (const auto name : names)
    {
        keys.push_back({.name = name, .noEffect = true});
    }
    return keys;
}

} // namespace slosh
