// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "dictionary/DictionaryNode.hpp"
#include "dictionary/mergeNodes.hpp"
#include "dictionary/tokenize.hpp"

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace slosh
{

/// Parses one file into a node; an included file gets a parser of its own on the same node. Only parse.cpp and
/// directives.cpp see it.
class Parser
{
public:
    using Node = Dictionary::Node;

    /// `file`: how messages call it; `folder`: where it lies; `caseFolder`: that of the file that includes all others;
    /// `depth`: how many do. Throws CaseError.
    Parser(
        std::string_view text, std::string file, std::filesystem::path folder, std::filesystem::path caseFolder,
        int depth
    );

    /// All entries up to the end, or up to the } of a dictionary that `openedAt` this line.
    void entriesOf(Node& node, bool inside, int openedAt, InputMode& mode);

private:
    [[noreturn]] void fail(int line, const std::string& message) const { throw errorIn(placeIn(file_, line), message); }

    const Token& next(const std::string& wanted);
    /// "a/b" { ... } is a { b { ... } }, as OpenFOAM takes it: the node of a; the keyword becomes b.
    Node& within(Node& outer, Token& keyword);
    void entry(Node& outer, InputMode& mode);
    /// Everything up to the ';' that ends the entry.
    void value(Node& node, const Token& keyword, std::vector<Token>& tokens, std::shared_ptr<Node>& dict);
    void expand(Node& node, const Token& macro, std::vector<Token>& tokens, std::shared_ptr<Node>& dict);
    /// -$name of a number.
    Token negative(Node& node, const Token& macro);
    Token evaluated(Node& node, const Token& text);
    /// $name; as a statement: its entries are inserted here.
    void insertDictionary(Node& node, const InputMode& mode);
    void directive(Node& node, InputMode& mode);
    /// name(p, U, start=1) is the function `name` of the file system/name, with fields (p U) and start 1; where there
    /// is no such file it is one of OpenFOAM's own, of which the name is known alone: name { type name; }.
    void includeFunction(Node& node, const Token& argument, const InputMode& mode);
    /// "(p, U, start=1)" as entries: "fields (p U); start 1;"
    static std::string argumentsOf(const std::string& list);
    void include(Node& node, const Token& name, const Token& argument, InputMode& mode);

    std::string file_;
    std::filesystem::path folder_; ///< of the file
    std::filesystem::path case_;   ///< of the file that includes all others
    int depth_;
    std::vector<Token> tokens_;
    std::size_t at_ = 0;
};

} // namespace slosh
