// SPDX-License-Identifier: GPL-3.0-or-later
#include "dictionary/parse.hpp"

#include "base/numberText.hpp"
#include "dictionary/Parser.hpp"
#include "dictionary/expression.hpp"
#include "dictionary/macros.hpp"
#include "dictionary/pathInCase.hpp"

#include <cstdlib>
#include <stdexcept>

namespace slosh
{

using Node = Dictionary::Node;
namespace fs = std::filesystem;

Parser::Parser(std::string_view text, std::string file, fs::path folder, fs::path caseFolder, int depth)
    : file_(std::move(file)), folder_(std::move(folder)), case_(std::move(caseFolder)), depth_(depth),
      tokens_(tokenize(text, file_))
{
    if (depth_ > 64)
    {
        throw CaseError(file_ + ": included more than 64 levels deep; does it include itself?", CaseError::Kind::input);
    }
}

void Parser::entriesOf(Node& node, bool inside, int openedAt, InputMode& mode)
{
    for (; at_ < tokens_.size();)
    {
        const Token& token = tokens_[at_];
        node.lastLine = token.line;
        if (token.is('}') && inside)
        {
            ++at_;
            return;
        }
        if (token.is(';'))
        {
            ++at_; // OpenFOAM takes a stray ';' after a sub-dictionary
            continue;
        }
        if (token.kind == Token::Kind::punctuation || token.kind == Token::Kind::number)
        {
            fail(token.line, "'" + token.text + "' found; expected a keyword");
        }
        if (token.kind == Token::Kind::word && token.text[0] == '#')
        {
            directive(node, mode);
        }
        else if (token.kind == Token::Kind::word && token.text[0] == '$' && at_ + 1 < tokens_.size() &&
                 (tokens_[at_ + 1].is(';')))
        {
            insertDictionary(node, mode);
        }
        else
        {
            entry(node, mode);
        }
    }
    if (inside)
    {
        fail(openedAt, "the dictionary '" + node.name + "' is not closed; expected '}'");
    }
}

const Token& Parser::next(const std::string& wanted)
{
    if (at_ >= tokens_.size())
    {
        fail(tokens_.empty() ? 0 : tokens_.back().line, "the file ends; expected " + wanted);
    }
    return tokens_[at_++];
}

Node& Parser::within(Node& outer, Token& keyword)
{
    Node* node = &outer;
    for (auto slash = keyword.text.find('/'); slash != std::string::npos; slash = keyword.text.find('/'))
    {
        Dictionary::Entry& entry = node->add(keyword.text.substr(0, slash), false);
        if (!entry.dict)
        {
            entry.file = file_;
            entry.line = keyword.line;
            entry.tokens.clear();
            entry.dict = std::make_shared<Node>();
            entry.dict->name = node->name + "/" + entry.key;
            entry.dict->file = file_;
            entry.dict->line = keyword.line;
            entry.dict->parent = node;
        }
        node = entry.dict.get();
        keyword.text.erase(0, slash + 1);
        keyword.kind = Token::Kind::word;
    }
    return *node;
}

void Parser::entry(Node& outer, InputMode& mode)
{
    Token keyword = next("a keyword");
    Node& node = keyword.kind == Token::Kind::string ? within(outer, keyword) : outer;
    const bool pattern = keyword.kind == Token::Kind::string;
    const bool opensDict = at_ < tokens_.size() && tokens_[at_].is('{');
    Dictionary::Entry* present = node.findLiteral(keyword.text);
    if (present != nullptr && mode == InputMode::error)
    {
        fail(keyword.line, keyword.text + " is set twice (#inputMode error)");
    }
    const bool keep = present != nullptr && mode == InputMode::protect;
    std::vector<Token> tokens;
    std::shared_ptr<Node> dict;
    if (opensDict)
    {
        ++at_;
        dict = std::make_shared<Node>();
        if (present != nullptr && present->dict && mode != InputMode::overwrite)
        {
            dict = present->dict;
        }
        else
        {
            dict->line = keyword.line;
        }
        dict->name = node.name + "/" + keyword.text;
        dict->file = file_;
        dict->parent = &node;
        InputMode inner = mode;
        entriesOf(*dict, true, keyword.line, inner);
    }
    else
    {
        value(node, keyword, tokens, dict);
    }
    if (!keep)
    {
        Dictionary::Entry& target = node.add(keyword.text, pattern);
        target.file = file_;
        target.line = keyword.line;
        target.tokens = std::move(tokens);
        target.dict = dict;
    }
}

void Parser::value(Node& node, const Token& keyword, std::vector<Token>& tokens, std::shared_ptr<Node>& dict)
{
    std::vector<char> open;
    while (true)
    {
        if (at_ >= tokens_.size())
        {
            fail(keyword.line, "the entry " + keyword.text + " does not end; expected ';'");
        }
        const Token& token = tokens_[at_++];
        if (token.is(';') && open.empty())
        {
            return;
        }
        if (token.kind == Token::Kind::punctuation && token.text[0] != ';')
        {
            const char c = token.text[0];
            const bool uniformList = !tokens.empty() && tokens.back().kind == Token::Kind::number;
            if ((c == '{' && open.empty() && !uniformList) || (c == '}' && open.empty()))
            {
                fail(keyword.line, "the entry " + keyword.text + " does not end; expected ';'");
            }
            if (c == '(' || c == '[' || c == '{')
            {
                open.push_back(c == '(' ? ')' : c == '[' ? ']' : '}');
            }
            else if (open.empty() || open.back() != c)
            {
                fail(token.line, "unexpected '" + token.text + "' in the entry " + keyword.text);
            }
            else
            {
                open.pop_back();
            }
            tokens.push_back(token);
        }
        else if (token.kind == Token::Kind::word && (token.text == "#eval" || token.text == "#calc"))
        {
            tokens.push_back(evaluated(node, next("an expression")));
        }
        else if (token.kind == Token::Kind::word && token.text.starts_with("-$") && token.text.size() > 2)
        {
            tokens.push_back(negative(node, token));
        }
        else if (token.kind == Token::Kind::word && token.text[0] == '$' && token.text.size() > 1)
        {
            expand(node, token, tokens, dict);
        }
        else
        {
            tokens.push_back(token);
        }
    }
}

void Parser::expand(Node& node, const Token& macro, std::vector<Token>& tokens, std::shared_ptr<Node>& dict)
{
    const std::string name = macroName(macro.text);
    if (const Dictionary::Entry* found = lookUp(node, name))
    {
        if (found->dict)
        {
            dict = copyOf(*found->dict, node.name, &node);
            return;
        }
        for (Token token : found->tokens)
        {
            token.line = macro.line;
            tokens.push_back(std::move(token));
        }
        return;
    }
    if (const char* value = std::getenv(name.c_str()))
    {
        Token token{Token::Kind::word, value, 0, macro.line};
        token.kind = isNumber(token.text, token.number) ? Token::Kind::number : Token::Kind::string;
        tokens.push_back(token);
        return;
    }
    fail(macro.line, "the macro " + macro.text + " is neither an entry nor an environment variable");
}

Token Parser::negative(Node& node, const Token& macro)
{
    std::vector<Token> value;
    std::shared_ptr<Node> dict;
    expand(node, macro, value, dict);
    if (value.size() != 1 || value[0].kind != Token::Kind::number)
    {
        fail(macro.line, "the macro " + macro.text + " is not a number");
    }
    const double x = -value[0].number;
    return {Token::Kind::number, numberText(x), x, macro.line};
}

Token Parser::evaluated(Node& node, const Token& text)
{
    const auto variable = [&](const std::string& name)
    {
        const Dictionary::Entry* found = lookUp(node, name);
        if (found == nullptr || found->tokens.size() != 1 || found->tokens[0].kind != Token::Kind::number)
        {
            throw std::invalid_argument("'$" + name + "' is not a number");
        }
        return found->tokens[0].number;
    };
    try
    {
        const double x = evaluateExpression(text.text, variable);
        return {Token::Kind::number, numberText(x), x, text.line};
    }
    catch (const std::invalid_argument& why)
    {
        fail(text.line, "the expression '" + text.text + "': " + why.what());
    }
}

void Parser::insertDictionary(Node& node, const InputMode& mode)
{
    const Token macro = next("a macro");
    const Dictionary::Entry* found = lookUp(node, macroName(macro.text));
    if (found == nullptr || !found->dict)
    {
        fail(macro.line, "the macro " + macro.text + " is not a dictionary");
    }
    merge(node, *copyOf(*found->dict, node.name, &node), mode);
}

static void forgetParents(Node& node)
{
    node.parent = nullptr;
    for (auto& entry : node.entries)
    {
        if (entry.dict)
        {
            forgetParents(*entry.dict);
        }
    }
}

void parseInto(Node& root, std::string_view text, const std::string& name, const fs::path& folder)
{
    root.name = name;
    root.file = name;
    InputMode mode = InputMode::merge;
    Parser(text, name, folder, caseOf(folder), 0).entriesOf(root, false, 0, mode);
    forgetParents(root);
}

} // namespace slosh
