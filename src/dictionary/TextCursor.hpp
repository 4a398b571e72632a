// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cctype>
#include <cstddef>
#include <string_view>

namespace slosh
{

/// What small grammars (expressions, dimensions) read their text with.
class TextCursor
{
protected:
    explicit TextCursor(std::string_view text) : text_(text) {}

    /// The next character behind blanks, '\0' at the end.
    char peek()
    {
        while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_])) != 0)
        {
            ++at_;
        }
        return at_ < text_.size() ? text_[at_] : '\0';
    }
    /// Whether it is `c`, which is then passed.
    bool take(char c)
    {
        const bool found = peek() == c;
        at_ += found;
        return found;
    }

    std::string_view text_;
    std::size_t at_ = 0;
};

} // namespace slosh
