// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <charconv>
#include <string>

namespace slosh
{

/// A number as short as it reads back to the same bits, or with `digits` significant ones.
inline std::string numberText(double value)
{
    char text[40];
    return {text, std::to_chars(text, text + sizeof text, value).ptr};
}

inline std::string numberText(double value, int digits)
{
    char text[40];
    return {text, std::to_chars(text, text + sizeof text, value, std::chars_format::general, digits).ptr};
}

} // namespace slosh
