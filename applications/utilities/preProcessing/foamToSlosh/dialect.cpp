// SPDX-License-Identifier: GPL-3.0-or-later
#include "dialect.hpp"

#include "theirFiles.hpp"

#include "dictionary/readText.hpp"
#include "dictionary/tokenize.hpp"

#include <algorithm>

namespace slosh
{

namespace
{

std::string textOf(const Case& theirs, const std::string& file)
{
    try
    {
        return hasFile(theirs, file) ? readText(theirs.root() / file, file) : "";
    }
    catch (const CaseError&)
    {
        return ""; // whoever needs it will say so
    }
}

/// Whether a word stands in a file, not in a comment.
bool hasWord(const Case& theirs, const std::string& file, const std::string& word)
{
    try
    {
        const std::vector<Token> tokens = tokenize(textOf(theirs, file), file);
        return std::any_of(tokens.begin(), tokens.end(), [&](const Token& token) { return token.text == word; });
    }
    catch (const CaseError&)
    {
        return false;
    }
}

} // namespace

std::string dialectOf(const Case& theirs)
{
    // The headline of every file names that one.
    if (textOf(theirs, "system/controlDict").find("foam-extend") != std::string::npos)
    {
        return "foam-extend (system/controlDict)";
    }
    struct Sign
    {
        std::string file, word; ///< the file itself where there is no word
    };
    const auto signIn = [&](const std::vector<Sign>& signs) -> std::string
    {
        for (const auto& [file, word] : signs)
        {
            if (word.empty() ? hasFile(theirs, file) : hasWord(theirs, file, word))
            {
                return " (" + (word.empty() ? "" : word + " in ") + file + ")";
            }
        }
        return "";
    };
    const std::string recent = signIn(
        {{"constant/phaseProperties", ""},
         {"constant/dynamicMeshDict", "mover"},
         {"system/setFieldsDict", "zones"},
         {"constant/momentumTransport", ""},
         {"system/functions", ""}}
    );
    if (!recent.empty())
    {
        return "OpenFOAM 10 or later" + recent;
    }
    const std::string old = signIn({{"system/setFieldsDict", "alpha1"}, {"constant/transportProperties", "phase1"}});
    return old.empty() ? "" : "foam-extend, or OpenFOAM before 2.3" + old;
}

} // namespace slosh
