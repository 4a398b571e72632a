// SPDX-License-Identifier: GPL-3.0-or-later
#include "ListReader.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>

namespace slosh
{

ListReader::ListReader(const Dictionary& dict, const std::string& key) : file_(dict.name()), tokens_(dict.tokens(key))
{
    if (tokens_.size() > 1 && tokens_[0].kind == Token::Kind::number && tokens_[1].is('('))
    {
        at_ = 1;
    }
}

bool ListReader::nextIsWord(const std::string& word) const
{
    return !atEnd() && tokens_[at_].kind == Token::Kind::word && (word.empty() || tokens_[at_].text == word);
}

std::string ListReader::place() const
{
    return placeIn(file_, tokens_.empty() ? 0 : tokens_[std::min(at_, tokens_.size() - 1)].line);
}

CaseError ListReader::misplaced(const std::string& wanted) const
{
    return errorIn(place(), (atEnd() ? "the list ends" : "'" + tokens_[at_].text + "' found") + "; expected " + wanted);
}

const Token& ListReader::take(const std::string& wanted, Token::Kind kind)
{
    if (atEnd() || tokens_[at_].kind != kind)
    {
        throw misplaced(wanted);
    }
    return tokens_[at_++];
}

void ListReader::expect(char punctuation)
{
    if (!nextIs(punctuation))
    {
        throw misplaced(std::string("a '") + punctuation + "'");
    }
    ++at_;
}

std::string ListReader::word()
{
    return !atEnd() && tokens_[at_].kind == Token::Kind::string ? tokens_[at_++].text
                                                                : take("a word", Token::Kind::word).text;
}

double ListReader::number()
{
    return take("a number", Token::Kind::number).number;
}

int ListReader::label()
{
    const double value = take("a whole number", Token::Kind::number).number;
    if (value != std::floor(value) || std::abs(value) > 1e9)
    {
        --at_;
        throw misplaced("a whole number");
    }
    return static_cast<int>(value);
}

Vec ListReader::vector()
{
    expect('(');
    Vec value;
    for (double& component : value)
    {
        component = number();
    }
    expect(')');
    return value;
}

std::vector<int> ListReader::labels()
{
    expect('(');
    std::vector<int> values;
    while (!nextIs(')'))
    {
        values.push_back(label());
    }
    expect(')');
    return values;
}

void ListReader::skip()
{
    int depth = 0;
    do
    {
        if (atEnd())
        {
            throw misplaced("a value");
        }
        const Token& token = tokens_[at_++];
        if (token.kind == Token::Kind::punctuation)
        {
            depth += std::string_view("([{").find(token.text[0]) != std::string_view::npos ? 1 : token.is(';') ? 0 : -1;
        }
    } while (depth > 0);
}

Dictionary ListReader::dictionary(const std::string& name)
{
    const std::size_t begin = at_;
    if (!nextIs('{'))
    {
        throw misplaced("the '{' of " + name);
    }
    skip();
    // Its text on its own lines, so that messages name them.
    std::string text;
    int line = 1;
    for (std::size_t k = begin + 1; k + 1 < at_; ++k)
    {
        const Token& token = tokens_[k];
        text += token.line > line ? std::string(static_cast<std::size_t>(token.line - line), '\n') : " ";
        line = std::max(line, token.line);
        text += token.kind == Token::Kind::string ? "\"" + token.text + "\"" : token.text;
    }
    return Dictionary::parse(text, file_);
}

} // namespace slosh
