// SPDX-License-Identifier: GPL-3.0-or-later
#include "motion/MotionFunction.hpp"

namespace slosh
{

double readOmega(const Dictionary& coeffs)
{
    const auto& tokens = coeffs.tokens("omega");
    if (tokens.size() == 2 && tokens[0].text == "constant" && tokens[1].kind == Token::Kind::number)
    {
        return tokens[1].number;
    }
    return coeffs.scalar("omega", unit::radianPerSecond);
}

} // namespace slosh
