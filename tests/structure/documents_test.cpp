// SPDX-License-Identifier: GPL-3.0-or-later
// All documents: links lead to files and headings that exist, lines are at most 140 columns long.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <string>
#include <vector>

namespace
{

namespace fs = std::filesystem;

const fs::path source = SLOSH_SOURCE;

std::vector<fs::path> documents()
{
    std::vector<fs::path> files;
    for (const auto& item : fs::directory_iterator(source))
    {
        if (item.path().extension() == ".md")
        {
            files.push_back(item.path());
        }
    }
    for (const std::string folder : {"docs", "tutorials", "benchmarks", "tests", "etc"})
    {
        for (const auto& item : fs::recursive_directory_iterator(source / folder))
        {
            if (item.path().extension() == ".md")
            {
                files.push_back(item.path());
            }
        }
    }
    std::sort(files.begin(), files.end());
    return files;
}

struct Line
{
    int number = 0;
    std::string text;
};

/// The lines outside of fenced blocks.
std::vector<Line> prose(const fs::path& file)
{
    std::vector<Line> lines;
    std::ifstream in(file);
    EXPECT_TRUE(in.good()) << file;
    bool isCode = false;
    int number = 0;
    for (std::string line; std::getline(in, line);)
    {
        ++number;
        if (line.find_first_not_of(' ') != std::string::npos &&
            line.substr(line.find_first_not_of(' ')).starts_with("```"))
        {
            isCode = !isCode;
        }
        else if (!isCode)
        {
            lines.push_back({number, line});
        }
    }
    return lines;
}

/// What a browser calls a heading: "## Time step, limits" is #time-step-limits.
std::string anchorOf(const std::string& heading)
{
    std::string anchor;
    for (const char c : heading.substr(heading.find(' ') + 1))
    {
        const auto letter = static_cast<unsigned char>(c);
        if (c == ' ')
        {
            anchor += '-';
        }
        else if (std::isalnum(letter) != 0 || c == '-' || c == '_' || letter >= 0x80)
        {
            anchor += static_cast<char>(std::tolower(letter));
        }
    }
    return anchor;
}

std::set<std::string> anchorsOf(const fs::path& file)
{
    std::set<std::string> anchors;
    for (const Line& line : prose(file))
    {
        if (line.text.starts_with("#"))
        {
            anchors.insert(anchorOf(line.text));
        }
    }
    return anchors;
}

/// Where a relative link of a document does not lead anywhere: why not; empty: it does.
std::string fault(const fs::path& file, const std::string& target, const std::string& anchor)
{
    const fs::path to = target.empty() ? file : file.parent_path() / target;
    if (!fs::exists(to))
    {
        return target + " does not exist";
    }
    if (!anchor.empty() && anchorsOf(to).count(anchor) == 0)
    {
        return target + " has no heading #" + anchor;
    }
    return "";
}

std::string placeOf(const fs::path& file, const Line& line)
{
    return fs::relative(file, source).string() + ":" + std::to_string(line.number);
}

TEST(Documents, LinkToFilesAndHeadingsThatExist)
{
    const std::regex link(R"(\]\(([^)#:\s]*)(?:#([^)\s]*))?\))");
    int links = 0;
    for (const fs::path& file : documents())
    {
        for (const Line& line : prose(file))
        {
            for (std::sregex_iterator at(line.text.begin(), line.text.end(), link), end; at != end; ++at)
            {
                EXPECT_EQ(fault(file, (*at)[1], (*at)[2]), "") << placeOf(file, line);
                ++links;
            }
        }
    }
    EXPECT_GT(links, 100);
    EXPECT_EQ(fault(source / "README.md", "docs/theory.md", ""), "");
    EXPECT_EQ(fault(source / "README.md", "docs/none.md", ""), "docs/none.md does not exist");
    EXPECT_EQ(fault(source / "README.md", "docs/theory.md", "none"), "docs/theory.md has no heading #none");
}

/// Rows of tables, and blocks of commands and of what they print, cannot be broken.
TEST(Documents, HaveLinesOfAtMost140Columns)
{
    int lines = 0;
    for (const fs::path& file : documents())
    {
        for (const Line& line : prose(file))
        {
            const auto columns = std::count_if(
                line.text.begin(), line.text.end(), [](unsigned char c) { return (c & 0xc0) != 0x80; } // UTF-8
            );
            ++lines;
            EXPECT_TRUE(columns <= 140 || line.text.starts_with("|") || line.text.starts_with("    "))
                << placeOf(file, line) << " has " << columns << " columns";
        }
    }
    EXPECT_GT(lines, 1000);
}

} // namespace
