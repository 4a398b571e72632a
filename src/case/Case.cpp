// SPDX-License-Identifier: GPL-3.0-or-later
#include "case/Case.hpp"

#include "dictionary/tokenize.hpp"

#include <algorithm>

namespace slosh
{

namespace fs = std::filesystem;

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
        throw CaseError("cannot open case directory \"" + root.string() +
                        "\": a case has the directories constant and system");
    }
}

std::string Case::name() const
{
    return root_.filename().string();
}

Dictionary Case::dictionary(const std::string& file) const
{
    return read_.emplace_back(Dictionary::read(root_ / file, file));
}

Dictionary Case::dictionaryIfPresent(const std::string& file) const
{
    std::error_code failure;
    return fs::exists(root_ / file, failure) ? dictionary(file) : Dictionary(file);
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
    std::sort(times.begin(), times.end(),
              [](const TimeDirectory& a, const TimeDirectory& b) { return a.value < b.value; });
    return times;
}

Vec Case::gravity() const
{
    const Dictionary g = dictionary("constant/g");
    if (g.has("dimensions"))
    {
        g.requireDimensions("dimensions", unit::acceleration);
    }
    const Vec value = g.vector("value", unit::acceleration);
    g.refuseUnknown();
    return value;
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
