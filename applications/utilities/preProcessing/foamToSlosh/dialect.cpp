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
        return ""; // what needs the file reports it
    }
}

/// Whether a file has a dictionary of that name.
bool hasDictionary(const Case& theirs, const std::string& file, const std::string& name)
{
    try
    {
        return hasFile(theirs, file) && dictionaryIn(theirs, file).isDict(name);
    }
    catch (const CaseError&)
    {
        return false;
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
    const std::string recent = "OpenFOAM 10 or later", old = "foam-extend, or OpenFOAM before 2.3";
    for (const std::string file : {"constant/phaseProperties", "system/functions"})
    {
        if (hasFile(theirs, file))
        {
            return recent + " (" + file + ")";
        }
    }
    struct Sign
    {
        std::string file, name, dialect;
    };
    for (const auto& [file, name, dialect] :
         {Sign{"constant/dynamicMeshDict", "mover", recent}, Sign{"system/setFieldsDict", "zones", recent},
          Sign{"constant/transportProperties", "phase1", old}})
    {
        if (hasDictionary(theirs, file, name))
        {
            return dialect + " (" + name + " in " + file + ")";
        }
    }
    return hasWord(theirs, "system/setFieldsDict", "alpha1") ? old + " (alpha1 in system/setFieldsDict)" : "";
}

} // namespace slosh
