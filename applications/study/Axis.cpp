// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/Axis.hpp"

#include "base/numberText.hpp"
#include "base/pointText.hpp"
#include "dictionary/tokenize.hpp"

#include <algorithm>
#include <cctype>

namespace slosh
{

namespace
{

std::vector<std::string> namesOf(const DictionaryFiles& files)
{
    std::vector<std::string> names;
    names.reserve(files.size());
    for (const auto& file : files)
    {
        names.push_back(file.first);
    }
    return names;
}

/// "viscosity { alpha 0.01; }" of "viscosity.alpha" and "0.01".
std::string entryText(const std::string& entry, const std::string& value)
{
    const auto dot = entry.find('.');
    return dot == std::string::npos ? entry + " " + value + ";"
                                    : entry.substr(0, dot) + " { " + entryText(entry.substr(dot + 1), value) + " }";
}

/// The words or numbers of a list, which name directories.
std::vector<std::string> labelsOf(const Dictionary& dict)
{
    std::vector<std::string> labels;
    const auto& tokens = dict.tokens(axisEntries::values);
    if (tokens.size() < 3 || !tokens.front().is('(') || !tokens.back().is(')'))
    {
        throw dict.errorAt(axisEntries::values, "is not a list; expected (a b ...) of words or numbers");
    }
    labels.reserve(tokens.size());
    for (auto token = tokens.begin() + 1; token != tokens.end() - 1; ++token)
    {
        const auto isPlain = [](unsigned char c) {
            return std::isalnum(c) != 0 ||
                   std::string_view("+-._").find(static_cast<char>(c)) != std::string_view::npos;
        };
        if (token->kind == Token::Kind::punctuation || !std::all_of(token->text.begin(), token->text.end(), isPlain))
        {
            throw dict.errorAt(
                axisEntries::values,
                "has '" + token->text +
                    "', which cannot be part of a folder's name; expected named settings instead of values"
            );
        }
        labels.push_back(token->text);
    }
    return labels;
}

/// Those of a range, of ten digits: what rounding adds is no part of a name.
std::vector<std::string> labelsOfRange(const Dictionary& dict)
{
    const auto ends = dict.scalars(axisEntries::range);
    if (ends.size() != 2 || !(ends[0] < ends[1]))
    {
        throw dict.errorAt(axisEntries::range, "is not a range; expected (from to), from < to");
    }
    const long count = dict.label(axisEntries::count);
    std::vector<std::string> labels;
    for (long k = 0; k < count; ++k)
    {
        const double share = static_cast<double>(k) / static_cast<double>(count - 1);
        labels.push_back(numberText(ends[0] + share * (ends[1] - ends[0]), 10));
    }
    return labels;
}

/// `key`: values or range.
void readValues(const Dictionary& dict, const Key& key, const DictionaryFiles& files, Axis& axis)
{
    axis.file = dict.choice(axisEntries::file, namesOf(files), "file of the case");
    axis.entry = dict.word(axisEntries::entry);
    axis.isSpacing = axis.file == "system/blockParticlesDict" && axis.entry == "particleSpacing";
    if (dict.has(axisEntries::direction))
    {
        axis.direction = dict.vector(axisEntries::direction);
    }
    for (const auto& label : key.name == axisEntries::range.name ? labelsOfRange(dict) : labelsOf(dict))
    {
        double number = 0;
        if (axis.direction && !isNumber(label, number))
        {
            throw dict.errorAt(key, "has '" + label + "'; expected numbers, factors of the direction");
        }
        axis.values.push_back({label, axis.editsFor(label)});
    }
}

/// Of system { sphSchemes { ... } }, which "system/sphSchemes" { ... } is as well: `folder` is "system/" inside it.
void readEdits(const Dictionary& dict, const std::string& folder, const DictionaryFiles& files, Edits& edits)
{
    for (const auto& key : dict.keys())
    {
        const std::string path = folder + key;
        const auto inside = files.lower_bound(path + "/");
        if (files.count(path) > 0)
        {
            edits[path] = dict.dict(key).text();
        }
        else if (inside != files.end() && inside->first.starts_with(path + "/"))
        {
            readEdits(dict.dict(key), path + "/", files, edits);
        }
        else
        {
            throw unknownName("file of the case", path, dict.placeOf(key), namesOf(files));
        }
    }
}

void readSettings(const Dictionary& settings, const DictionaryFiles& files, Axis& axis)
{
    for (const auto& label : settings.keys())
    {
        Axis::Value value{label, {}};
        readEdits(settings.dict(label), "", files, value.edits);
        axis.values.push_back(value);
    }
}

} // namespace

Edits Axis::editsFor(const std::string& value) const
{
    if (!direction)
    {
        return {{file, entryText(entry, value)}};
    }
    double factor = 0;
    isNumber(value, factor);
    const Vec vector = factor * *direction;
    return {{file, entryText(entry, exactText(vector))}};
}

std::size_t Axis::indexOf(const std::string& label, const std::string& place) const
{
    std::vector<std::string> labels;
    labels.reserve(values.size());
    for (const auto& value : values)
    {
        labels.push_back(value.label);
    }
    const auto found = std::find(labels.begin(), labels.end(), label);
    if (found == labels.end())
    {
        throw unknownName("value of the axis " + name, label, place, labels);
    }
    return static_cast<std::size_t>(found - labels.begin());
}

Axis readAxis(const Dictionary& dict, const std::string& name, const DictionaryFiles& files)
{
    Axis axis;
    axis.name = name;
    const Key& key = dict.has(axisEntries::settings) ? axisEntries::settings
                     : dict.has(axisEntries::range)  ? axisEntries::range
                                                     : axisEntries::values;
    if (key.name == axisEntries::settings.name)
    {
        readSettings(dict.dict(key), files, axis);
    }
    else
    {
        readValues(dict, key, files, axis);
    }
    dict.refuseUnknown(); // what goes with other values than these is unknown, too
    if (axis.values.empty())
    {
        throw dict.errorAt(key, "is empty");
    }
    for (std::size_t i = 0; i < axis.values.size(); ++i)
    {
        if (axis.indexOf(axis.values[i].label, "") != i)
        {
            throw dict.errorAt(key, "has '" + axis.values[i].label + "' twice");
        }
    }
    return axis;
}

} // namespace slosh
