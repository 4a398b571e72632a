// SPDX-License-Identifier: GPL-3.0-or-later
#include "motion/MotionFunction.hpp"

namespace slosh
{

Key omegaKey()
{
    return {
        .name = "omega",
        .example = "4",
        .unit = unit::radianPerSecond,
        .sentence = "a number, or `constant` before it as in later OpenFOAM"};
}

double readOmega(const Dictionary& coeffs)
{
    const auto& tokens = coeffs.tokens(omegaKey());
    if (tokens.size() == 2 && tokens[0].text == "constant" && tokens[1].kind == Token::Kind::number)
    {
        return tokens[1].number;
    }
    return coeffs.scalar(omegaKey());
}

} // namespace slosh
