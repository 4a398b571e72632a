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

} // namespace slosh
