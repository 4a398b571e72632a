// SPDX-License-Identifier: GPL-3.0-or-later
#include "dictionary/dimensions.hpp"

#include "dictionary/TextCursor.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <map>
#include <sstream>
#include <string_view>

namespace slosh
{

namespace
{

const std::map<std::string, Dimensions, std::less<>>& symbols()
{
    static const std::map<std::string, Dimensions, std::less<>> table = {
        {"kg", {{1}}},
        {"m", {{0, 1}}},
        {"s", {{0, 0, 1}}},
        {"K", {{0, 0, 0, 1}}},
        {"mol", {{0, 0, 0, 0, 1}}},
        {"A", {{0, 0, 0, 0, 0, 1}}},
        {"Cd", {{0, 0, 0, 0, 0, 0, 1}}},
        {"Hz", {{0, 0, -1}}},
        {"N", {{1, 1, -2}}},
        {"Pa", {{1, -1, -2}}},
        {"J", {{1, 2, -2}}},
        {"W", {{1, 2, -3}}},
        {"area", {{0, 2}}},
        {"volume", {{0, 3}}},
        {"density", {{1, -3}}},
        {"acceleration", {{0, 1, -2}}},
        {"kinematicPressure", {{0, 2, -2}}},
        {"cm", {{0, 1}, 1e-2}},
        {"mm", {{0, 1}, 1e-3}},
        {"km", {{0, 1}, 1e3}}};
    return table;
}

/// product: power, then * / or a blank and the next one. power: a symbol or a product in parentheses, ^ and a number.
class Symbols : TextCursor
{
public:
    explicit Symbols(std::string_view text) : TextCursor(text) {}

    std::optional<Dimensions> whole()
    {
        const auto all = product();
        return all && peek() == '\0' ? all : std::nullopt;
    }

private:
    std::optional<Dimensions> product()
    {
        auto all = power();
        while (all && peek() != '\0' && peek() != ')')
        {
            const double sign = take('/') ? -1 : 1;
            if (sign > 0)
            {
                take('*');
            }
            const auto next = power();
            all = next ? std::optional(times(*all, *next, sign)) : std::nullopt;
        }
        return all;
    }

    std::optional<Dimensions> power()
    {
        const auto base = take('(') ? inParentheses() : symbol();
        if (!base || !take('^'))
        {
            return base;
        }
        double exponent = 0;
        const bool bracket = take('(');
        peek();
        const auto [end, error] = std::from_chars(text_.data() + at_, text_.data() + text_.size(), exponent);
        at_ = static_cast<std::size_t>(end - text_.data());
        return error == std::errc() && (!bracket || take(')')) ? std::optional(times({}, *base, exponent))
                                                               : std::nullopt;
    }

    std::optional<Dimensions> inParentheses()
    {
        const auto all = product();
        return take(')') ? all : std::nullopt;
    }

    std::optional<Dimensions> symbol()
    {
        peek();
        const std::size_t begin = at_;
        while (at_ < text_.size() && std::isalpha(static_cast<unsigned char>(text_[at_])) != 0)
        {
            ++at_;
        }
        const auto found = symbols().find(text_.substr(begin, at_ - begin));
        return found != symbols().end() ? std::optional(found->second) : std::nullopt;
    }

    /// a b^n
    static Dimensions times(Dimensions a, const Dimensions& b, double n)
    {
        for (std::size_t k = 0; k < a.exponent.size(); ++k)
        {
            a.exponent[k] += n * b.exponent[k];
        }
        a.factor *= std::pow(b.factor, n);
        return a;
    }
};

} // namespace

std::optional<Dimensions> readDimensions(std::span<const Token> tokens)
{
    const auto isNumber = [](const Token& token) { return token.kind == Token::Kind::number; };
    if (std::all_of(tokens.begin(), tokens.end(), isNumber))
    {
        if (tokens.size() != 5 && tokens.size() != 7)
        {
            return std::nullopt;
        }
        Dimensions dimensions;
        std::transform(
            tokens.begin(), tokens.end(), dimensions.exponent.begin(), [](const Token& token) { return token.number; }
        );
        return dimensions;
    }
    std::string text;
    for (const Token& token : tokens)
    {
        text += token.text + " ";
    }
    return Symbols(text).whole();
}

std::string dimensionsText(const std::array<double, 7>& exponents)
{
    std::ostringstream text;
    text << "[";
    for (std::size_t k = 0; k < exponents.size(); ++k)
    {
        text << (k == 0 ? "" : " ") << exponents[k];
    }
    text << "]";
    return text.str();
}

} // namespace slosh
