// SPDX-License-Identifier: GPL-3.0-or-later
// Directives: #include, #includeIfPresent, #sinclude, #includeEtc, #includeFunc, #inputMode, #remove.
#include "dictionary/Parser.hpp"
#include "dictionary/etcFolder.hpp"
#include "dictionary/pathInCase.hpp"
#include "dictionary/readText.hpp"

#include <algorithm>

namespace slosh
{

namespace fs = std::filesystem;

void Parser::directive(Node& node, InputMode& mode)
{
    const Token name = next("a directive");
    const Token argument = next("the argument of " + name.text);
    if (name.text == "#include" || name.text == "#includeIfPresent" || name.text == "#sinclude" ||
        name.text == "#includeEtc")
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
            {"#include", "#includeIfPresent", "#sinclude", "#includeEtc", "#includeFunc", "#inputMode", "#remove",
             "#eval", "#calc"}
        );
    }
}

void Parser::includeFunction(Node& node, const Token& argument, const InputMode& mode)
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

std::string Parser::argumentsOf(const std::string& list)
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

void Parser::include(Node& node, const Token& name, const Token& argument, InputMode& mode)
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
                argument.line,
                "#includeEtc \"" + path + "\": the environment variable SLOSH_ETC is not set; source etc/bashrc"
            );
        }
        file = *etc / path;
    }
    if ((name.text == "#includeIfPresent" || name.text == "#sinclude") && !fs::exists(file))
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

} // namespace slosh
