// SPDX-License-Identifier: GPL-3.0-or-later
#include "dictionary/parse.hpp"

#include "base/numberText.hpp"
#include "dictionary/etcFolder.hpp"
#include "dictionary/expression.hpp"
#include "dictionary/macros.hpp"
#include "dictionary/mergeNodes.hpp"
#include "dictionary/pathInCase.hpp"
#include "dictionary/readText.hpp"
#include "dictionary/tokenize.hpp"

#include <cstdlib>
#include <stdexcept>

namespace slosh
{

namespace
{

using Node = Dictionary::Node;
namespace fs = std::filesystem;

/// Parses one file into a node; an included file gets a parser of its own on the same node.
class Parser
{
public:
    Parser(std::string_view text, std::string file, fs::path folder, fs::path caseFolder, int depth)
        : file_(std::move(file)), folder_(std::move(folder)), case_(std::move(caseFolder)), depth_(depth),
          tokens_(tokenize(text, file_))
    {
        if (depth_ > 64)
        {
            throw CaseError(
                file_ + ": included more than 64 levels deep; does it include itself?", CaseError::Kind::input
            );
        }
    }

    void entriesOf(Node& node, bool inside, int openedAt, InputMode& mode)
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

private:
    [[noreturn]] void fail(int line, const std::string& message) const { throw errorIn(placeIn(file_, line), message); }

    const Token& next(const std::string& wanted)
    {
        if (at_ >= tokens_.size())
        {
            fail(tokens_.empty() ? 0 : tokens_.back().line, "the file ends; expected " + wanted);
        }
        return tokens_[at_++];
    }

    /// "a/b" { ... } is a { b { ... } }, as OpenFOAM takes it: the node of a; the keyword becomes b.
    Node& within(Node& outer, Token& keyword)
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

    void entry(Node& outer, InputMode& mode)
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

    /// Everything up to the ';' that ends the entry.
    void value(Node& node, const Token& keyword, std::vector<Token>& tokens, std::shared_ptr<Node>& dict)
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

    void expand(Node& node, const Token& macro, std::vector<Token>& tokens, std::shared_ptr<Node>& dict)
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
        fail(macro.line, "the macro " + macro.text + " names no entry and no environment variable");
    }

    /// -$name of a number.
    Token negative(Node& node, const Token& macro)
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

    Token evaluated(Node& node, const Token& text)
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

    /// $name; as a statement: its entries are inserted here.
    void insertDictionary(Node& node, const InputMode& mode)
    {
        const Token macro = next("a macro");
        const Dictionary::Entry* found = lookUp(node, macroName(macro.text));
        if (found == nullptr || !found->dict)
        {
            fail(macro.line, "the macro " + macro.text + " names no dictionary");
        }
        merge(node, *copyOf(*found->dict, node.name, &node), mode);
    }

    void directive(Node& node, InputMode& mode)
    {
        const Token name = next("a directive");
        const Token argument = next("the argument of " + name.text);
        if (name.text == "#include" || name.text == "#includeIfPresent" || name.text == "#includeEtc")
        {
            include(node, name, argument, mode);
        }
        else if (name.text == "#inputMode")
        {
            const std::string& word = argument.text;
            if (word == "merge" || word == "default" || word == "warn")
            {
                mode = InputMode::merge;
            }
            else if (word == "overwrite" || word == "protect" || word == "error")
            {
                mode = word == "overwrite" ? InputMode::overwrite
                       : word == "protect" ? InputMode::protect
                                           : InputMode::error;
            }
            else
            {
                throw unknownName(
                    "#inputMode", word, placeIn(file_, argument.line),
                    {"merge", "overwrite", "protect", "error", "default", "warn"}
                );
            }
        }
        else if (name.text == "#remove")
        {
            if (!argument.is('('))
            {
                node.remove(argument.text);
                return;
            }
            for (Token token = next("')'"); !token.is(')'); token = next("')'"))
            {
                node.remove(token.text);
            }
        }
        else if (name.text == "#includeFunc")
        {
            includeFunction(node, argument, mode);
        }
        else
        {
            throw unknownName(
                "directive", name.text, placeIn(file_, name.line),
                {"#include", "#includeIfPresent", "#includeEtc", "#includeFunc", "#inputMode", "#remove", "#eval",
                 "#calc"}
            );
        }
    }

    /// name(p, U, start=1) is the function `name` of the file system/name, with fields (p U) and start 1; where there
    /// is no such file it is one of OpenFOAM's own, of which the name is known alone: name { type name; }.
    void includeFunction(Node& node, const Token& argument, const InputMode& mode)
    {
        const std::size_t open = std::min(argument.text.find('('), argument.text.size());
        const std::string name = argument.text.substr(0, open);
        const fs::path file = case_ / "system" / name;
        std::string text = "type " + name + ";";
        std::string shown = file_;
        if (fs::is_regular_file(file))
        {
            shown = "system/" + name;
            text = readText(file, shown);
        }
        auto function = std::make_shared<Node>();
        function->name = node.name + "/" + name;
        function->file = shown;
        function->line = argument.line;
        function->parent = &node;
        InputMode inner = InputMode::merge;
        Parser(text, shown, file.parent_path(), case_, depth_ + 1).entriesOf(*function, false, 0, inner);
        Parser(argumentsOf(argument.text.substr(open)), file_, folder_, case_, depth_ + 1)
            .entriesOf(*function, false, 0, inner);
        if (node.findLiteral(name) == nullptr || mode != InputMode::protect)
        {
            Dictionary::Entry& entry = node.add(name, false);
            entry.file = file_;
            entry.line = argument.line;
            entry.tokens.clear();
            entry.dict = function;
        }
    }

    /// "(p, U, start=1)" as entries: "fields (p U); start 1;"
    static std::string argumentsOf(const std::string& list)
    {
        std::string fields, entries;
        for (std::size_t begin = 1, end = 1; end + 1 < list.size(); begin = end + 1)
        {
            end = std::min(list.find(',', begin), list.size() - 1);
            std::string argument = list.substr(begin, end - begin);
            const auto equals = argument.find('=');
            if (equals == std::string::npos)
            {
                fields += argument + " ";
                continue;
            }
            argument[equals] = ' ';
            entries += argument + "; ";
        }
        return (fields.empty() ? "" : "fields (" + fields + "); ") + entries;
    }

    void include(Node& node, const Token& name, const Token& argument, InputMode& mode)
    {
        const std::string& path = argument.text;
        const auto inCase = pathInCase(path);
        fs::path file = inCase ? case_ / *inCase : folder_ / path;
        if (name.text == "#includeEtc")
        {
            const auto etc = etcFolder();
            if (!etc)
            {
                fail(
                    argument.line, "#includeEtc \"" + path + "\": the variable SLOSH_ETC is not set; source etc/bashrc"
                );
            }
            file = *etc / path;
        }
        if (name.text == "#includeIfPresent" && !fs::exists(file))
        {
            return;
        }
        if (!fs::is_regular_file(file))
        {
            fail(argument.line, "cannot find the included file \"" + path + "\"");
        }
        const std::string shown = inCase ? *inCase : (fs::path(file_).parent_path() / path).string();
        Parser inner(readText(file, shown), shown, file.parent_path(), case_, depth_ + 1);
        inner.entriesOf(node, false, 0, mode);
    }

    std::string file_;
    fs::path folder_; ///< of the file
    fs::path case_;   ///< of the file that includes all others
    int depth_;
    std::vector<Token> tokens_;
    std::size_t at_ = 0;
};

void forgetParents(Node& node)
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

} // namespace

void parseInto(Node& root, std::string_view text, const std::string& name, const fs::path& folder)
{
    root.name = name;
    root.file = name;
    InputMode mode = InputMode::merge;
    Parser(text, name, folder, caseOf(folder), 0).entriesOf(root, false, 0, mode);
    forgetParents(root);
}

} // namespace slosh
