// SPDX-License-Identifier: GPL-3.0-or-later
#include "case/Case.hpp"

#include "dictionary/readText.hpp"
#include "dictionary/tokenize.hpp"

#include <algorithm>

namespace slosh
{

namespace fs = std::filesystem;

namespace
{

namespace g
{

constexpr Key dimensions{.name = "dimensions", .otherwise = "[0 1 -2 0 0 0 0]"};
constexpr Key value{.name = "value", .example = "(0 0 -9.81)", .unit = unit::acceleration};

} // namespace g

} // namespace

Keys gravityKeys()
{
    return {g::dimensions, g::value};
}

Case::Case(const fs::path& root)
{
    std::error_code failure;
    if (!fs::is_directory(root, failure))
    {
        throw CaseError("cannot open case directory \"" + root.string() + "\"");
    }
    root_ = fs::canonical(root);
    if (!fs::is_directory(root_ / "constant", failure) || !fs::is_directory(root_ / "system", failure))
    {
        throw CaseError(
            "cannot open case directory \"" + root.string() + "\": a case has the directories constant and system"
        );
    }
}

std::string Case::name() const
{
    return root_.filename().string();
}

Dictionary Case::dictionary(const std::string& file) const
{
    if (!isThere(root_ / file))
    {
        Dictionary::read(root_ / file, file); // says that it cannot
    }
    return read_.emplace_back(completed(file));
}

Dictionary Case::dictionaryIfPresent(const std::string& file) const
{
    return read_.emplace_back(completed(file));
}

const NamedScheme& Case::scheme() const
{
    const std::string file = "system/sphSchemes";
    return schemeNamedIn(isThere(root_ / file) ? Dictionary::read(root_ / file, file) : Dictionary(file));
}

Dictionary Case::completed(const std::string& file) const
{
    Dictionary dict = isThere(root_ / file) ? Dictionary::read(root_ / file, file) : Dictionary(file);
    const NamedScheme& named = scheme();
    const auto& entries = named.entries;
    if (std::none_of(entries.begin(), entries.end(), [&](const SchemeEntry& entry) { return entry.file == file; }))
    {
        return dict;
    }
    if (file == "system/sphSchemes")
    {
        schemeNamedIn(dict); // a key it knows
    }
    for (const SchemeEntry& entry : entries)
    {
        const auto holds = [&](const SchemeEntry::Condition& condition) {
            return (condition.file == file ? dict : completed(condition.file)).textAt(condition.path) ==
                   condition.value;
        };
        if (entry.file == file && std::all_of(entry.onlyWith.begin(), entry.onlyWith.end(), holds))
        {
            dict.setDefault(entry.path, entry.value, "scheme " + named.name);
        }
    }
    return dict;
}

std::vector<std::string> Case::schemeParts() const
{
    std::vector<std::string> parts;
    for (const SchemeEntry& entry : scheme().entries)
    {
        const Dictionary dict = completed(entry.file);
        const std::string value = dict.textAt(entry.path);
        const std::string part = entry.path + " " + value + " (" + dict.placeOf(entry.path) + ")";
        if (!value.empty() && std::find(parts.begin(), parts.end(), part) == parts.end())
        {
            parts.push_back(part);
        }
    }
    return parts;
}

std::vector<std::string> Case::unusedEntries() const
{
    std::vector<std::string> unused;
    for (const auto& dict : read_)
    {
        const auto more = dict.unusedEntries();
        unused.insert(unused.end(), more.begin(), more.end());
    }
    return unused;
}

std::vector<TimeDirectory> Case::times() const
{
    std::vector<TimeDirectory> times;
    for (const auto& item : fs::directory_iterator(root_))
    {
        TimeDirectory time{item.path().filename().string(), 0};
        if (isNumber(time.name, time.value) && fs::is_directory(item.path() / "lagrangian"))
        {
            times.push_back(time);
        }
    }
    std::sort(
        times.begin(), times.end(), [](const TimeDirectory& a, const TimeDirectory& b) { return a.value < b.value; }
    );
    return times;
}

Vec Case::gravity() const
{
    const Dictionary dict = dictionary("constant/g");
    if (dict.has(g::dimensions))
    {
        dict.requireDimensions(g::dimensions, g::value.unit);
    }
    const Vec gravity = dict.vector(g::value);
    dict.refuseUnknown(gravityKeys());
    return gravity;
}

void Case::removeTime(const std::string& name) const
{
    std::error_code failure;
    fs::remove_all(root_ / name, failure);
    if (failure)
    {
        throw CaseError("cannot remove the time directory " + name + ": " + failure.message());
    }
}

} // namespace slosh
