// SPDX-License-Identifier: GPL-3.0-or-later
#include "turnedFunction1.hpp"

#include "base/numberText.hpp"

namespace slosh
{

namespace
{

using Tokens = std::vector<Token>;

/// The same with every (x y z) in it multiplied by M.
std::string withVectorsTimes(const Mat& M, Tokens tokens)
{
    for (std::size_t k = 0; k + 4 < tokens.size(); ++k)
    {
        Vec X;
        bool isVector = tokens[k].is('(') && tokens[k + 4].is(')');
        for (int d = 0; d < 3 && isVector; ++d)
        {
            isVector = tokens[k + 1 + d].kind == Token::Kind::number;
            X[d] = tokens[k + 1 + d].number;
        }
        if (!isVector)
        {
            continue;
        }
        const Vec turned = M * X + Vec::Zero(); // no -0
        for (int d = 0; d < 3; ++d)
        {
            tokens[k + 1 + d].text = numberText(turned[d]);
        }
    }
    return textOf(tokens);
}

CaseError cannotBeTurned(const Dictionary& dict, const std::string& key, const std::string& type)
{
    return dict.errorAt(
        key,
        "is of type " + type +
            ", which cannot be turned so that gravity is along -z; expected constant, table, sine, cosine or square"
    );
}

/// amplitude(t) wave(t) scale(t) + level(t), the last two vectors.
Dictionary turnedWave(const Dictionary& theirs, const Mat& M)
{
    Dictionary ours(theirs.name());
    for (const std::string& entry : theirs.keys())
    {
        if (entry == "scale" || entry == "level")
        {
            setTurned(theirs, entry, M, ours);
        }
        else if (entry == "scaleCoeffs" || entry == "levelCoeffs")
        {
            continue; // with its entry
        }
        else if (theirs.isDict(entry))
        {
            ours.set(entry, theirs.dict(entry));
        }
        else
        {
            ours.set(entry, textOf(theirs.tokens(entry)));
        }
    }
    if (!theirs.has("scale"))
    {
        ours.set("scale", Vec(M * Vec::Ones()));
    }
    return ours;
}

} // namespace

std::string textOf(const Tokens& tokens)
{
    std::string text;
    for (const Token& token : tokens)
    {
        text += " " + (token.kind == Token::Kind::string ? "\"" + token.text + "\"" : token.text);
    }
    return text;
}

void setTurned(const Dictionary& from, const std::string& key, const Mat& M, Dictionary& to)
{
    const bool isDict = from.isDict(key), isApart = !isDict && from.tokens(key).size() == 1;
    if (!isDict && !isApart)
    {
        const Tokens& tokens = from.tokens(key);
        const bool isNamed = tokens[0].kind == Token::Kind::word && !tokens[1].is('['); // no name before dimensions
        if (isNamed && tokens[0].text != "constant" && tokens[0].text != "table")
        {
            throw cannotBeTurned(from, key, tokens[0].text);
        }
        to.set(key, withVectorsTimes(M, tokens));
        return;
    }
    const Dictionary theirs = from.dict(isDict ? key : key + "Coeffs");
    const std::string type = isDict ? theirs.word("type") : from.word(key);
    Dictionary ours(key);
    if (type == "sine" || type == "cosine" || type == "square")
    {
        ours = turnedWave(theirs, M);
    }
    else if (type == "constant" || type == "table")
    {
        for (const std::string& entry : theirs.keys())
        {
            ours.set(entry, withVectorsTimes(M, theirs.tokens(entry)));
        }
    }
    else
    {
        throw cannotBeTurned(from, key, type);
    }
    ours.set("type", type);
    to.set(key, ours);
}

} // namespace slosh
