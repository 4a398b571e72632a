// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/CaseError.hpp"

#include <algorithm>
#include <cctype>
#include <cstddef>

namespace slosh
{

namespace
{

std::string lowerCase(std::string text)
{
    std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return char(std::tolower(c)); });
    return text;
}

/// Edits (insert, delete, replace, swap neighbours) that turn a into b.
std::size_t editDistance(const std::string& a, const std::string& b)
{
    std::vector<std::vector<std::size_t>> d(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
    for (std::size_t i = 0; i <= a.size(); ++i)
    {
        for (std::size_t j = 0; j <= b.size(); ++j)
        {
            if (i == 0 || j == 0)
            {
                d[i][j] = i + j;
                continue;
            }
            d[i][j] = std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, d[i - 1][j - 1] + (a[i - 1] != b[j - 1])});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
            {
                d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
            }
        }
    }
    return d[a.size()][b.size()];
}

} // namespace

std::string CaseError::text() const
{
    return std::string(kind_ == Kind::input ? "--> FOAM FATAL IO ERROR:\n" : "--> FOAM FATAL ERROR:\n") + what() + "\n";
}

std::string placeIn(const std::string& file, int line)
{
    return file + (line > 0 ? ":" + std::to_string(line) : "");
}

CaseError errorIn(const std::string& place, const std::string& message)
{
    return CaseError(place + ": " + message, CaseError::Kind::input);
}

std::string nearestName(const std::string& word, const std::vector<std::string>& valid)
{
    const std::string wanted = lowerCase(word);
    std::string nearest;
    std::size_t least = (word.size() < 5 ? 1 : std::max<std::size_t>(2, word.size() / 3)) + 1;
    for (const auto& name : valid)
    {
        const std::string candidate = lowerCase(name);
        std::size_t distance = editDistance(wanted, candidate);
        // "gaussian" for "improvedGaussian": a word that is part of a name is meant by it.
        if (wanted.size() >= 4 && candidate.find(wanted) != std::string::npos)
        {
            distance = std::min<std::size_t>(distance, 1);
        }
        if (distance < least)
        {
            least = distance;
            nearest = name;
        }
    }
    return nearest;
}

/// "kernel types", "axes", "quantities", "ways to vary", "files of the case".
static std::string pluralOf(const std::string& what)
{
    const std::string rest = what.substr(std::min({what.size(), what.find(" of "), what.find(" to ")}));
    std::string noun = what.substr(0, what.size() - rest.size());
    if (noun.ends_with("y") && !noun.ends_with("ay"))
    {
        noun.replace(noun.size() - 1, 1, "ie");
    }
    else if (noun.ends_with("is"))
    {
        noun.replace(noun.size() - 2, 2, "e");
    }
    return noun + (noun.ends_with("s") ? "" : "s") + rest;
}

CaseError
unknownName(const std::string& what, const std::string& word, const std::string& place, std::vector<std::string> valid)
{
    std::sort(valid.begin(), valid.end());
    std::string message = place + (place.empty() ? "" : ": ") + "unknown " + what + " '" + word + "'";
    if (const auto nearest = nearestName(word, valid); !nearest.empty())
    {
        message += "; did you mean '" + nearest + "'?";
    }
    message += "\nValid " + pluralOf(what) + ":";
    for (const auto& name : valid)
    {
        message += " " + name;
    }
    return CaseError(message, CaseError::Kind::input);
}

} // namespace slosh
