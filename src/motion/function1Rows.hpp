// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "motion/Function1.hpp"

#include <cmath>

namespace slosh
{

/// A row of a table, or a term of a polynomial.
struct Function1Row
{
    double argument = 0;
    std::array<double, 3> value{};
};

/// A number, or (x y z), at place `at` of tokens, which is moved on; nothing where there is none.
inline std::optional<std::array<double, 3>>
function1Value(std::span<const Token> tokens, std::size_t& at, bool isVector)
{
    std::array<double, 3> value{};
    const std::size_t numbers = isVector ? 3 : 1, needed = isVector ? 5 : 1;
    if (at + needed > tokens.size() || (isVector && (!tokens[at].is('(') || !tokens[at + 4].is(')'))))
    {
        return std::nullopt;
    }
    for (std::size_t k = 0; k < numbers; ++k)
    {
        const Token& token = tokens[at + (isVector ? 1 : 0) + k];
        if (token.kind != Token::Kind::number || !std::isfinite(token.number))
        {
            return std::nullopt;
        }
        value[k] = token.number;
    }
    at += needed;
    return value;
}

/// The rows ((a b) ...), with or without a count before them; nothing where the tokens are no such list.
inline std::optional<std::vector<std::array<std::array<double, 3>, 2>>>
function1Pairs(std::span<const Token> tokens, bool isVectorA, bool isVectorB)
{
    std::vector<std::array<std::array<double, 3>, 2>> pairs;
    std::size_t at = !tokens.empty() && tokens[0].kind == Token::Kind::number ? 1 : 0;
    const auto take = [&](char c) { return at < tokens.size() && tokens[at].is(c) && ++at > 0; };
    bool isSound = take('(');
    while (isSound && !take(')'))
    {
        isSound = take('(');
        const auto a = function1Value(tokens, at, isVectorA);
        const auto b = function1Value(tokens, at, isVectorB);
        isSound = isSound && a && b && take(')');
        if (isSound)
        {
            pairs.push_back({*a, *b});
        }
    }
    return isSound && at == tokens.size() ? std::optional(pairs) : std::nullopt;
}

} // namespace slosh
