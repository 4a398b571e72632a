// SPDX-License-Identifier: GPL-3.0-or-later
#include "motion/MotionFunction.hpp"

namespace slosh
{

Key omegaKey()
{
    return {
        .name = "omega", .example = "4", .unit = unit::radianPerSecond, .sentence = "a number, or a Function1 of time"};
}

Keys function1Coeffs(const std::vector<std::string_view>& names)
{
    Keys keys;
    for (const std::string_view name : names)
    {
        keys.push_back(
            {.name = name,
             .example = "frequency 0.5; amplitude 4;",
             .sentence = "coefficients of a Function1 given by its name",
             .entries = noKeys,
             .alternative = true}
        );
    }
    return keys;
}

} // namespace slosh
