// SPDX-License-Identifier: GPL-3.0-or-later
#include "motion/Function1.hpp"

#include <algorithm>

namespace slosh
{

std::unique_ptr<Function1>
readFunction1(const Dictionary& dict, const Key& key, bool isVector, const std::string& caseFolder)
{
    const auto named = [&](const std::string& name) -> const Function1::Choice&
    {
        for (const Function1::Choice& choice : Function1::choices())
        {
            if (choice.name == name)
            {
                return choice;
            }
        }
        throw unknownName("Function1", name, dict.placeOf(key), namesOf(Function1::choices()));
    };
    if (!dict.has(key) && !key.otherwise.empty())
    {
        const Vec x = isVector ? dict.vector(key) : Vec(dict.scalar(key), 0, 0);
        return constantFunction({x[0], x[1], x[2]}, isVector);
    }
    if (dict.isDict(key))
    {
        const Dictionary inner = dict.dict(key);
        auto function = named(inner.word("type")).read({inner, key, isVector, caseFolder, {}});
        inner.refuseUnknown();
        return function;
    }
    const std::span<const Token> tokens = dict.tokens(key);
    const bool hasName = !tokens.empty() && tokens[0].kind == Token::Kind::word &&
                         !(tokens.size() > 1 && tokens[1].is('[')); // `omega omega [0 0 -1 0 0 0 0] 4`
    if (!hasName)
    {
        const Vec x = isVector ? dict.vector(key) : Vec(dict.scalar(key), 0, 0);
        return constantFunction({x[0], x[1], x[2]}, isVector);
    }
    const Function1::Choice& choice = named(tokens[0].text);
    const std::string coeffs = std::string(key.name) + "Coeffs";
    if (tokens.size() > 1 || !dict.has(coeffs))
    {
        return choice.read({dict, key, isVector, caseFolder, tokens.subspan(1)});
    }
    const Dictionary inner = dict.dict(coeffs);
    auto function = choice.read({inner, key, isVector, caseFolder, {}});
    inner.refuseUnknown();
    return function;
}

double lastTimeOf(std::initializer_list<const std::unique_ptr<Function1>*> functions)
{
    double last = std::numeric_limits<double>::infinity();
    for (const auto* function : functions)
    {
        last = std::min(last, (*function)->lastTime());
    }
    return last;
}

std::unique_ptr<Function1> Function1Setting::part(std::string_view name, double otherwise, bool isLikeThis) const
{
    const bool vector = isVector && isLikeThis;
    if (!dict.has(name))
    {
        return constantFunction({otherwise, otherwise, otherwise}, vector);
    }
    return readFunction1(dict, {.name = name, .unit = isLikeThis ? key.unit : unit::none}, vector, caseFolder);
}

} // namespace slosh
