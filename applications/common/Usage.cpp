// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/Usage.hpp"

#include "base/CaseError.hpp"

#include <algorithm>
#include <iomanip>
#include <sstream>

namespace slosh
{

namespace
{

std::string leftOf(const Usage::Row& option)
{
    return "-" + option.name + (option.what.empty() ? "" : " <" + option.what + ">");
}

/// Text as roff has to have it: backslashes and dashes escaped, no dot or quote at the start of a line.
std::string roff(const std::string& text)
{
    std::string escaped;
    for (const char c : text)
    {
        escaped += c == '\\' ? "\\e" : c == '-' ? "\\-" : c == '\'' ? "\\(aq" : std::string(1, c);
    }
    return escaped.empty() || escaped[0] != '.' ? escaped : "\\&" + escaped;
}

void writeRows(std::ostream& out, const std::string& heading, const std::vector<Usage::Row>& rows)
{
    if (rows.empty())
    {
        return;
    }
    out << heading << "\n";
    for (const auto& row : rows)
    {
        out << ".TP\n\\fB" << roff(row.name) << "\\fR" << (row.what.empty() ? "" : " <\\fI" + roff(row.what) + "\\fR>")
            << "\n"
            << roff(row.description) << "\n";
    }
}

/// Adds the entries, those inside dictionaries as "limits/courantNumber"; one with the same words, no second time.
void addEntries(const Keys& keys, const std::string& inside, std::vector<Usage::Row>& rows)
{
    for (const Key& key : withThoseOfOptions(keys))
    {
        const std::string name = inside + (key.anyName ? "<any name>" : std::string(key.name));
        const std::string what = describe(key);
        const bool isKnown = std::any_of(
            rows.begin(), rows.end(), [&](const auto& row) { return row.name == name && row.description == what; }
        );
        if (!key.noEffect && !isKnown && !what.empty())
        {
            rows.push_back({name, "", what});
        }
        addEntries(key.entries == nullptr ? Keys() : key.entries(), name + "/", rows);
    }
}

/// "compareSamples(1), ...": the others of the programs that the build makes.
std::string otherPrograms(const std::string& name)
{
    std::vector<std::string> all;
    std::istringstream in(SLOSH_PROGRAMS);
    for (std::string program; in >> program;)
    {
        all.push_back(program);
    }
    std::sort(all.begin(), all.end());
    std::string text;
    for (const auto& program : all)
    {
        if (program != name)
        {
            text += (text.empty() ? "\\fB" : ", \\fB") + program + "\\fR(1)";
        }
    }
    return text;
}

} // namespace

std::string Usage::help() const
{
    constexpr int width = 28;
    std::ostringstream out;
    out << "Usage: " << name << " [OPTIONS]\n\n" << purpose << "\n" << std::left;
    const auto list = [&](const std::string& title, const std::vector<Row>& rows, const auto& left)
    {
        out << (rows.empty() ? "" : "\n" + title + ":\n");
        for (const auto& row : rows)
        {
            const std::string before = left(row);
            out << "  " << std::setw(width) << before
                << (std::ssize(before) < width ? "" : "\n  " + std::string(width, ' ')) << row.description << "\n";
        }
    };
    list("Options", options, leftOf);
    list("Files", files, [](const Row& row) { return row.name; });
    list("Environment", variables, [](const Row& row) { return row.name; });
    for (const auto& choice : choices)
    {
        list("Names for " + choice.entry, choice.names, [](const Row& row) { return row.name; });
    }
    out << "\nExample:\n  " << example << "\n";
    return out.str();
}

std::string Usage::manPage() const
{
    std::ostringstream out;
    out << ".TH " << name << " 1 \"\" \"SloshSPH " << SLOSH_VERSION << "\" \"SloshSPH\"\n"
        << ".SH NAME\n"
        << name << " \\- " << roff(purpose.substr(0, purpose.find_last_not_of('.') + 1)) << "\n"
        << ".SH SYNOPSIS\n.B " << name << "\n[\\fIOPTIONS\\fR]\n"
        << ".SH DESCRIPTION\n"
        << roff(purpose)
        << "\n.PP\nA case is a directory with dictionaries in OpenFOAM syntax in constant/ and system/. A "
           "commented\nexample of each, with every key, its unit and its default, is in share/sloshsph/etc/annotated "
           "of the installation;\ntutorials are in share/sloshsph/tutorials, the user guide is in "
           "share/doc/sloshsph.\n";
    std::vector<Row> dashed = options;
    for (auto& option : dashed)
    {
        option.name.insert(0, "-");
    }
    writeRows(out, ".SH OPTIONS", dashed);
    out << ".SH EXAMPLE\nNext to a copy of the tutorials:\n.PP\n.nf\n.RS 4\n"
        << roff(example) << "\n.RE\n.fi\n"
        << ".SH EXIT STATUS\n0: success. 1: error; the message, with file and line of a wrong entry, is on standard "
           "error.\n";
    writeRows(out, ".SH ENVIRONMENT", variables);
    writeRows(out, ".SH FILES", files);
    for (const auto& dictionary : dictionaries)
    {
        std::vector<Row> entries;
        addEntries(dictionary.keys(), "", entries);
        writeRows(out, ".SH ENTRIES OF " + roff(dictionary.path), entries);
    }
    out << (choices.empty() ? "" : ".SH NAMES IN DICTIONARIES\n");
    for (const auto& choice : choices)
    {
        writeRows(out, ".SS " + roff(choice.entry), choice.names);
    }
    out << ".SH SEE ALSO\n" << otherPrograms(name) << "\n";
    return out.str();
}

std::string Usage::annotated(const std::string& path) const
{
    std::vector<std::string> paths;
    for (const auto& dictionary : dictionaries)
    {
        if (dictionary.path == path)
        {
            return dictionary.file();
        }
        paths.push_back(dictionary.path);
    }
    throw unknownName("dictionary of " + name, path, "", paths);
}

} // namespace slosh
