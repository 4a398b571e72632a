// SPDX-License-Identifier: GPL-3.0-or-later
// The typed reads of a Dictionary.
#include "dictionary/Dictionary.hpp"

#include "dictionary/dimensions.hpp"
#include "dictionary/rangeText.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>

namespace slosh
{

namespace
{

using Tokens = std::vector<Token>;

std::string shown(const Tokens& tokens)
{
    std::string text;
    for (const auto& token : tokens)
    {
        const bool glued = text.empty() || text.back() == '(' || token.is(')') || text.back() == '[' || token.is(']');
        text += (glued ? "" : " ") + token.text;
        if (text.size() > 60)
        {
            return text + " ...";
        }
    }
    return text;
}

/// " [kg/m^3]", "" of a number without dimensions.
std::string inBrackets(const Unit& unit)
{
    const bool hasName = unit.name != "dimensionless" && !unit.name.empty();
    return hasName ? " [" + std::string(unit.name) + "]" : "";
}

/// "is -998; expected a number > 0 [kg/m^3]"
std::string mismatch(const Tokens& found, const std::string& expected)
{
    return (found.empty() ? "has no value" : "is " + shown(found)) + "; expected " + expected;
}

std::string wanted(const Unit& unit, const Range& range, const std::string& what = "a number")
{
    std::ostringstream text;
    text << what;
    const std::string values = rangeText(range);
    text << (values.empty() ? "" : " ") << values;
    text << inBrackets(unit);
    return text.str();
}

/// Takes [1 -3 0 0 0 0 0] or [kg m^-3] off the front, and the name that OpenFOAM's old form puts before it.
std::optional<Dimensions> takeDimensions(const Dictionary& dict, std::string_view key, Tokens& tokens)
{
    auto open = tokens.begin();
    if (open != tokens.end() && open->kind == Token::Kind::word && tokens.size() > 1 && tokens[1].is('['))
    {
        ++open;
    }
    if (open == tokens.end() || !open->is('['))
    {
        return std::nullopt;
    }
    const auto close = std::find_if(open, tokens.end(), [](const Token& t) { return t.is(']'); });
    const auto dimensions = readDimensions({open + 1, close});
    if (!dimensions)
    {
        throw dict.errorAt(
            key, "has the dimensions " + shown(Tokens(open, close == tokens.end() ? close : close + 1)) +
                     "; expected the 7 (or 5) exponents of [kg m s K mol A cd], or symbols, [m s^-2]"
        );
    }
    tokens.erase(tokens.begin(), close + 1);
    return dimensions;
}

/// "a/b" of the tokens `a / b`, which is how OpenFOAM's programs write a path without quotes; empty where it is none.
std::string pathOf(const Tokens& tokens)
{
    std::string path;
    for (std::size_t k = 0; k < tokens.size(); ++k)
    {
        const bool slash = tokens[k].kind == Token::Kind::word && tokens[k].text == "/";
        if (slash != (k % 2 == 1) || tokens[k].kind == Token::Kind::punctuation)
        {
            return "";
        }
        path += tokens[k].text;
    }
    return tokens.size() > 2 && tokens.size() % 2 == 1 ? path : "";
}

/// Reads (a b c), with or without a count before it, or n{v}; f takes one element starting at `at` and moves it on.
template <class F>
bool readList(const Tokens& tokens, const F& f)
{
    std::size_t at = 0;
    if (tokens.size() > 2 && tokens[0].kind == Token::Kind::word && tokens[0].text.rfind("List<", 0) == 0)
    {
        ++at;
    }
    double count = -1;
    if (at < tokens.size() && tokens[at].kind == Token::Kind::number)
    {
        count = tokens[at++].number;
    }
    const bool uniform = at < tokens.size() && tokens[at].is('{') && count >= 0;
    if (at >= tokens.size() || !(tokens[at].is('(') || uniform))
    {
        return false;
    }
    ++at;
    long found = 0;
    const std::size_t first = at;
    for (; at < tokens.size() && !tokens[at].is(uniform ? '}' : ')'); ++found)
    {
        if (!f(tokens, at))
        {
            return false;
        }
    }
    for (; uniform && found < static_cast<long>(count); ++found)
    {
        std::size_t again = first;
        f(tokens, again);
    }
    return at + 1 == tokens.size() && (count < 0 || static_cast<long>(count) == found);
}

/// (x y z), or (a b) of a plane.
template <class Point>
bool readVector(const Tokens& tokens, std::size_t& at, Point& value)
{
    constexpr std::size_t n = Point::SizeAtCompileTime;
    if (at + n + 2 > tokens.size() || !tokens[at].is('(') || !tokens[at + n + 1].is(')'))
    {
        return false;
    }
    for (std::size_t d = 0; d < n; ++d)
    {
        const Token& token = tokens[at + 1 + d];
        if (token.kind != Token::Kind::number || !std::isfinite(token.number))
        {
            return false;
        }
        value[static_cast<Eigen::Index>(d)] = token.number;
    }
    at += n + 2;
    return true;
}

} // namespace

/// Throws where dimensions are given that are not those of `unit`; the factor of those that are.
static double
factorTo(const Dictionary& dict, std::string_view key, const std::optional<Dimensions>& dimensions, const Unit& unit)
{
    if (dimensions && dimensions->exponent != unit.exponent)
    {
        throw dict.errorAt(
            key, "has the dimensions " + dimensionsText(dimensions->exponent) + "; expected " +
                     dimensionsText(unit.exponent) + " (" + std::string(unit.name) + ")"
        );
    }
    return dimensions ? dimensions->factor : 1;
}

/// The tokens of an entry without its dimensions, which must be those of `unit`; numbers in this unit.
static Tokens inUnit(const Dictionary& dict, std::string_view key, const Unit& unit)
{
    Tokens tokens = dict.tokens(key);
    const double factor = factorTo(dict, key, takeDimensions(dict, key, tokens), unit);
    for (std::size_t k = 0; factor != 1 && k < tokens.size(); ++k)
    {
        const bool isCount = k + 1 < tokens.size() && (tokens[k + 1].is('(') || tokens[k + 1].is('{'));
        tokens[k].number *= isCount ? 1 : factor;
    }
    return tokens;
}

void Dictionary::requireDimensions(std::string_view key, const Unit& unit) const
{
    Tokens rest = tokens(key);
    const auto dimensions = takeDimensions(*this, key, rest);
    if (!dimensions || !rest.empty() || factorTo(*this, key, dimensions, unit) != 1)
    {
        throw errorAt(key, mismatch(tokens(key), dimensionsText(unit.exponent)));
    }
}

double Dictionary::scalar(std::string_view key, const Unit& unit, const Range& range) const
{
    const Tokens tokens = inUnit(*this, key, unit);
    const bool oneNumber = tokens.size() == 1 && tokens[0].kind == Token::Kind::number;
    if (!oneNumber || !range.contains(tokens[0].number))
    {
        const bool lacksEnd = tokens.size() > 1 && tokens[0].kind == Token::Kind::number;
        throw errorAt(key, mismatch(tokens, wanted(unit, range)) + (lacksEnd ? "; is a ';' missing?" : ""));
    }
    return tokens[0].number;
}

double Dictionary::scalarOr(std::string_view key, double otherwise, const Unit& unit, const Range& range) const
{
    return has(key) ? scalar(key, unit, range) : otherwise;
}

long Dictionary::label(std::string_view key, const Range& range) const
{
    const Tokens& value = tokens(key);
    constexpr double most = 9e15; // a double holds every whole number up to here
    if (value.size() != 1 || value[0].kind != Token::Kind::number || value[0].number != std::floor(value[0].number) ||
        std::abs(value[0].number) > most || !range.contains(value[0].number))
    {
        throw errorAt(key, mismatch(value, wanted(unit::none, range, "a whole number")));
    }
    return static_cast<long>(value[0].number);
}

long Dictionary::labelOr(std::string_view key, long otherwise, const Range& range) const
{
    return has(key) ? label(key, range) : otherwise;
}

std::string Dictionary::word(std::string_view key) const
{
    const Tokens& value = tokens(key);
    if (const std::string path = pathOf(value); !path.empty())
    {
        return path;
    }
    if (value.size() != 1 || value[0].kind == Token::Kind::punctuation || value[0].kind == Token::Kind::number)
    {
        throw errorAt(key, mismatch(value, "one word"));
    }
    return value[0].text;
}

std::string Dictionary::wordOr(std::string_view key, const std::string& otherwise) const
{
    return has(key) ? word(key) : otherwise;
}

Vec Dictionary::vector(std::string_view key, const Unit& unit) const
{
    const Tokens tokens = inUnit(*this, key, unit);
    std::size_t at = 0;
    Vec value = Vec::Zero();
    if (!readVector(tokens, at, value) || at != tokens.size())
    {
        throw errorAt(key, mismatch(tokens, "three numbers (x y z)" + inBrackets(unit)));
    }
    return value;
}

std::vector<double> Dictionary::scalars(std::string_view key, const Unit& unit, const Range& range) const
{
    const Tokens tokens = inUnit(*this, key, unit);
    std::vector<double> values;
    const bool sound = readList(
        tokens,
        [&](const Tokens& all, std::size_t& at)
        {
            const Token& token = all[at++];
            values.push_back(token.number);
            return token.kind == Token::Kind::number && range.contains(token.number);
        }
    );
    if (!sound)
    {
        throw errorAt(key, mismatch(tokens, "a list (a b ...) of " + wanted(unit, range, "numbers")));
    }
    return values;
}

namespace
{

template <class Point>
std::vector<Point> readPoints(const Dictionary& dict, std::string_view key, const Unit& unit, const std::string& form)
{
    const Tokens tokens = inUnit(dict, key, unit);
    std::vector<Point> values;
    const bool sound = readList(
        tokens,
        [&](const Tokens& all, std::size_t& at)
        {
            values.emplace_back(Point::Zero());
            return readVector(all, at, values.back());
        }
    );
    if (!sound)
    {
        throw dict.errorAt(key, mismatch(tokens, "a list (" + form + " ...) of points" + inBrackets(unit)));
    }
    return values;
}

} // namespace

std::vector<Vec> Dictionary::vectors(std::string_view key, const Unit& unit) const
{
    return readPoints<Vec>(*this, key, unit, "(x y z)");
}

std::vector<Vec2> Dictionary::planePoints(std::string_view key, const Unit& unit) const
{
    return readPoints<Vec2>(*this, key, unit, "(a b)");
}

std::vector<std::string> Dictionary::words(std::string_view key) const
{
    const Tokens& value = tokens(key);
    std::vector<std::string> words;
    const bool sound = readList(
        value,
        [&](const Tokens& all, std::size_t& at)
        {
            const Token& token = all[at++];
            words.push_back(token.text);
            return token.kind == Token::Kind::word || token.kind == Token::Kind::string;
        }
    );
    if (!sound)
    {
        throw errorAt(key, mismatch(value, "a list (a b ...) of words"));
    }
    return words;
}

} // namespace slosh
