// SPDX-License-Identifier: GPL-3.0-or-later
// The commands that README.md, docs/userGuide.md and docs/questions show, run as a reader runs them, and what they
// print held against what the page says they print.
#include "InstallationFolder.hpp"
#include "installed.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <fstream>
#include <iostream>
#include <iterator>
#include <regex>
#include <sstream>

namespace slosh
{
namespace
{

namespace fs = std::filesystem;

/// A fenced block of a page.
struct Block
{
    int line = 0;         ///< where it begins
    std::string language; ///< "bash": commands, "text": what the commands before it print, "foam": of a dictionary
    std::string text;
    std::string notRun;   ///< the reason, of <!-- not run: reason --> on the line before
    bool follows = false; ///< follows the block before it, with nothing but empty lines between

    bool isRun() const { return language == "bash" && notRun.empty(); }
};

/// The blocks of a page; a line outside of them that is indented as code is one by itself, "indented".
std::vector<Block> blocksOf(const std::string& page)
{
    std::vector<Block> blocks;
    std::ifstream in(fs::path(SLOSH_SOURCE) / page);
    const std::regex remark("<!-- not run: (.+) -->");
    std::string notRun;
    bool inside = false, follows = false;
    int number = 0;
    for (std::string line; std::getline(in, line);)
    {
        ++number;
        std::smatch match;
        if (line.rfind("```", 0) == 0)
        {
            inside = !inside;
            if (inside)
            {
                blocks.push_back({number, line.substr(3), "", notRun, follows});
            }
            follows = !inside;
            notRun = "";
        }
        else if (inside)
        {
            blocks.back().text += line + "\n";
        }
        else if (std::regex_match(line, match, remark))
        {
            notRun = match[1];
        }
        else if (!line.empty())
        {
            if (line.rfind("    ", 0) == 0)
            {
                blocks.push_back({number, "indented", line, "", false});
            }
            follows = false;
            notRun = "";
        }
    }
    return blocks;
}

std::vector<std::string> pages()
{
    std::vector<std::string> names = {"README.md", "docs/userGuide.md"};
    for (const auto& page : fs::directory_iterator(fs::path(SLOSH_SOURCE) / "docs/questions"))
    {
        names.push_back("docs/questions/" + page.path().filename().string());
    }
    std::sort(names.begin(), names.end());
    return names;
}

std::vector<std::string> linesOf(const std::string& text)
{
    std::vector<std::string> lines;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);)
    {
        lines.push_back(line);
    }
    return lines;
}

/// A line as a page shows it, to be found in what a program prints: blanks are any blanks, "..." any text; whole
/// numbers are the same, others within one unit of the last digit shown, as are whole
/// numbers with "..." behind them.
class ShownLine
{
public:
    explicit ShownLine(const std::string& shown)
    {
        static const std::regex part(R"((\.\.\.)|\s+|([-+]?\d+(\.\d+)?(e[-+]?\d+)?)|[^\s\d])");
        std::string pattern = R"(\s*)";
        for (std::sregex_iterator at(shown.begin(), shown.end(), part), end; at != end; ++at)
        {
            const std::string text = at->str();
            if ((*at)[1].matched)
            {
                // "6..." is a number with digits left out.
                if (at->position() > 0 && std::isdigit(static_cast<unsigned char>(shown[at->position() - 1])) != 0)
                {
                    numbers_.back().second = numbers_.back().second > 0 ? numbers_.back().second : 1;
                }
                pattern += ".*";
            }
            else if ((*at)[2].matched)
            {
                pattern += R"(([-+]?\d+(?:\.\d+)?(?:e[-+]?\d+)?))";
                numbers_.emplace_back(std::stod(text), unitOf(text));
            }
            else if (std::isspace(static_cast<unsigned char>(text[0])) != 0)
            {
                pattern += R"(\s+)";
            }
            else
            {
                pattern += std::ispunct(static_cast<unsigned char>(text[0])) != 0 ? "\\" + text : text;
            }
        }
        line_ = std::regex(pattern + R"(\s*)");
    }

    bool isIn(const std::string& printed) const
    {
        std::smatch match;
        if (!std::regex_match(printed, match, line_))
        {
            return false;
        }
        for (std::size_t k = 0; k < numbers_.size(); ++k)
        {
            if (std::abs(std::stod(match[k + 1]) - numbers_[k].first) > 1.0001 * numbers_[k].second)
            {
                return false;
            }
        }
        return true;
    }

private:
    /// One unit of the last digit, 0 for a whole number.
    static double unitOf(const std::string& number)
    {
        const auto e = number.find('e');
        const auto point = number.find('.');
        if (point == std::string::npos && e == std::string::npos)
        {
            return 0;
        }
        const auto end = std::min(e, number.size());
        const auto decimals = point == std::string::npos ? 0 : end - point - 1;
        const int exponent = e == std::string::npos ? 0 : std::stoi(number.substr(e + 1));
        return std::pow(10.0, exponent - static_cast<int>(decimals));
    }

    std::regex line_;
    std::vector<std::pair<double, double>> numbers_;
};

/// Expects the lines shown in what was printed, in their order; a line "..." stands for any.
void expectShown(const std::string& shown, const std::string& printed, const std::string& where)
{
    const std::vector<std::string> lines = linesOf(printed);
    auto from = lines.begin();
    for (const std::string& line : linesOf(shown))
    {
        if (line.empty() || line == "...")
        {
            continue;
        }
        const ShownLine wanted(line);
        const auto found =
            std::find_if(from, lines.end(), [&](const std::string& candidate) { return wanted.isIn(candidate); });
        EXPECT_NE(found, lines.end()) << where << " shows\n"
                                      << line << "\nwhich is not in what follows in\n"
                                      << printed;
        if (found == lines.end())
        {
            return;
        }
        from = found + 1;
    }
}

class Document : public testing::TestWithParam<std::string>
{
};

/// The pages with commands that are run.
std::vector<std::string> pagesWithCommands()
{
    std::vector<std::string> names = pages();
    const auto hasNone = [](const std::string& page)
    {
        const std::vector<Block> blocks = blocksOf(page);
        return std::none_of(blocks.begin(), blocks.end(), [](const Block& block) { return block.isRun(); });
    };
    names.erase(std::remove_if(names.begin(), names.end(), hasNone), names.end());
    return names;
}

/// In an empty folder, one block after the other in one shell that has sourced an installation's etc/bashrc, on one
/// thread, without a display.
TEST_P(Document, ItsCommandsRunAndPrintWhatItShows)
{
    const std::vector<Block> blocks = blocksOf(GetParam());
    std::string script = ". prefix/share/sloshsph/etc/bashrc\nmkdir empty\ncd empty\nexec 2>&1\n";
    std::string commands;
    for (std::size_t k = 0; k < blocks.size(); ++k)
    {
        if (blocks[k].isRun())
        {
            commands += blocks[k].text;
            script += "echo '#block " + std::to_string(k) + "'\n" + blocks[k].text;
        }
    }
    for (const auto& [word, program] :
         {std::pair{"sloshMonitor", "gnuplot"},
          {"gnuplot", "gnuplot"},
          {"foamDictionary", "foamDictionary"},
          {"foamToVTK", "foamToVTK"}})
    {
        if (commands.find(word) != std::string::npos && !isInstalled(program))
        {
            GTEST_SKIP() << program << " is not installed";
        }
    }
    const InstallationFolder folder;
    const Ended ended = folder.bash(script);
    ASSERT_EQ(ended.status, 0) << GetParam() << "\n" << ended.out << ended.err;
    for (std::size_t k = 1; k < blocks.size(); ++k)
    {
        if (blocks[k].language == "text" && blocks[k].follows && blocks[k - 1].isRun())
        {
            const std::string begin = "#block " + std::to_string(k - 1) + "\n";
            const auto at = ended.out.find(begin) + begin.size();
            expectShown(
                blocks[k].text, ended.out.substr(at, ended.out.find("#block ", at) - at),
                GetParam() + ":" + std::to_string(blocks[k].line)
            );
        }
    }
}

INSTANTIATE_TEST_SUITE_P(
    Of, Document, testing::ValuesIn(pagesWithCommands()),
    [](const auto& tested) { return std::regex_replace(tested.param, std::regex("[^A-Za-z0-9]"), "_"); }
);

TEST(Documents, HaveFewCommandsThatNoTestRunsEachWithItsReason)
{
    int run = 0, notRun = 0;
    for (const std::string& page : pages())
    {
        for (const Block& block : blocksOf(page))
        {
            const std::string where = page + ":" + std::to_string(block.line);
            EXPECT_TRUE(block.language == "bash" || block.language == "text" || block.language == "foam") << where;
            if (block.language == "bash")
            {
                ++(block.isRun() ? run : notRun);
                if (!block.notRun.empty())
                {
                    std::cout << where << ": not run: " << block.notRun << "\n";
                }
            }
        }
    }
    EXPECT_GE(run, 25);
    EXPECT_LE(notRun, 10);
}

} // namespace
} // namespace slosh
