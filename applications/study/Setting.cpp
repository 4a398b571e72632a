// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/Setting.hpp"

#include "dictionary/tokenize.hpp"

namespace slosh
{

namespace
{

Setting settingOf(const std::vector<Axis>& axes, const std::vector<std::size_t>& values)
{
    Setting setting;
    setting.values = values;
    const auto append = [](std::string& to, const std::string& part) { to += (to.empty() ? "" : "_") + part; };
    for (std::size_t k = 0; k < axes.size(); ++k)
    {
        const Axis::Value& value = axes[k].values[values[k]];
        const std::string part = axes[k].name + "=" + value.label;
        append(setting.name, part);
        if (axes[k].isSpacing)
        {
            isNumber(value.label, setting.wantedSpacing);
        }
        else
        {
            append(setting.scheme, part);
            if (!axes[k].isMember)
            {
                append(setting.family, part);
            }
        }
        for (const auto& [file, entries] : value.edits)
        {
            setting.edits[file] += entries + "\n";
        }
    }
    if (setting.scheme.empty())
    {
        setting.scheme = "-";
    }
    if (setting.family.empty())
    {
        setting.family = "-";
    }
    return setting;
}

std::vector<std::size_t> readBase(const Dictionary& base, const std::vector<Axis>& axes)
{
    std::vector<std::size_t> values;
    values.reserve(axes.size());
    for (const auto& axis : axes)
    {
        // A number is as good a label as a word.
        const auto tokens = base.has(axis.name) ? base.tokens(axis.name) : std::vector<Token>();
        const std::string label = tokens.empty() ? axis.values.front().label : tokens.front().text;
        values.push_back(axis.indexOf(label, base.placeOf(axis.name)));
    }
    base.refuseUnknown();
    return values;
}

std::vector<Setting> product(const std::vector<Axis>& axes)
{
    std::vector<Setting> all;
    std::vector<std::size_t> values(axes.size(), 0);
    // The last axis turns fastest, as the last digit of a number.
    for (bool done = false; !done;)
    {
        all.push_back(settingOf(axes, values));
        std::size_t k = axes.size();
        while (k > 0 && ++values[k - 1] == axes[k - 1].values.size())
        {
            values[--k] = 0;
        }
        done = k == 0;
    }
    return all;
}

std::vector<Setting> oneAtATime(const std::vector<Axis>& axes, const std::vector<std::size_t>& base)
{
    std::vector<Setting> all{settingOf(axes, base)};
    for (std::size_t k = 0; k < axes.size(); ++k)
    {
        for (std::size_t value = 0; value < axes[k].values.size(); ++value)
        {
            if (value != base[k])
            {
                auto values = base;
                values[k] = value;
                all.push_back(settingOf(axes, values));
            }
        }
    }
    return all;
}

} // namespace

std::vector<Setting> readSettings(const Dictionary& dict, const std::vector<Axis>& axes)
{
    if (dict.choice(settingEntries::vary, "way to vary") == "product")
    {
        return product(axes);
    }
    return oneAtATime(axes, readBase(dict.dictOr(settingEntries::base), axes));
}

bool differOnlyIn(std::size_t axis, const Setting& a, const Setting& b)
{
    if (a.values.size() <= axis || b.values.size() <= axis)
    {
        return false; // of a run that the axes know nothing about
    }
    for (std::size_t k = 0; k < a.values.size(); ++k)
    {
        if ((a.values[k] != b.values[k]) != (k == axis))
        {
            return false;
        }
    }
    return true;
}

} // namespace slosh
