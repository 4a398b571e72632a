// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace slosh
{

/// The smallest piece of a dictionary with the line it stands on.
struct Token
{
    enum class Kind
    {
        word,
        string, ///< text without its quotes
        number,
        punctuation ///< one of ( ) [ ] { } ;
    };

    Kind kind = Kind::word;
    std::string text;
    double number = 0;
    int line = 0;

    bool is(char punctuation) const { return kind == Kind::punctuation && text[0] == punctuation; }
};

} // namespace slosh
