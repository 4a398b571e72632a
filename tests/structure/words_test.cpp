// SPDX-License-Identifier: GPL-3.0-or-later
// The words of texts for users: no phrase of tests/structure/bannedPhrases in string literals or documents.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace
{

namespace fs = std::filesystem;

const fs::path source = SLOSH_SOURCE;

struct Phrase
{
    std::string words;   ///< lower case, one blank between words
    std::string instead; ///< what to write
};

/// A text with the line of each of its characters.
class LinedText
{
public:
    void add(char c, int line)
    {
        const bool isSpace = std::isspace(static_cast<unsigned char>(c)) != 0;
        if (isSpace && !text_.empty() && text_.back() == ' ')
        {
            return;
        }
        text_ += isSpace ? ' ' : static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
        lines_.push_back(line);
    }

    /// The lines where the phrase begins, as whole words.
    std::vector<int> linesOf(const std::string& phrase) const
    {
        const auto isLetter = [this](std::size_t at)
        { return at < text_.size() && std::isalnum(static_cast<unsigned char>(text_[at])) != 0; };
        std::vector<int> found;
        for (std::size_t at = text_.find(phrase); at != std::string::npos; at = text_.find(phrase, at + 1))
        {
            if ((at == 0 || !isLetter(at - 1)) && !isLetter(at + phrase.size()))
            {
                found.push_back(lines_[at]);
            }
        }
        return found;
    }

    bool empty() const { return text_.empty(); }

private:
    std::string text_;
    std::vector<int> lines_;
};

std::string contentOf(const fs::path& file)
{
    std::ifstream in(file);
    EXPECT_TRUE(in.good()) << file;
    return {std::istreambuf_iterator<char>(in), {}};
}

/// The string literals of C++, adjacent ones joined.
class Literals
{
public:
    explicit Literals(const std::string& code) : code_(code)
    {
        while (at_ < code_.size())
        {
            if (startsWith("//"))
            {
                skipTo("\n");
            }
            else if (startsWith("/*"))
            {
                skipTo("*/");
            }
            else if (startsWith("R\""))
            {
                raw();
            }
            else if (code_[at_] == '"')
            {
                ordinary();
            }
            else if (code_[at_] == '\'' && (at_ == 0 || std::isalnum(static_cast<unsigned char>(code_[at_ - 1])) == 0))
            {
                do
                {
                    next(code_[at_] == '\\' ? 2 : 1);
                } while (at_ < code_.size() && code_[at_] != '\'');
                next(1);
            }
            else
            {
                isOpen_ = isOpen_ && std::isspace(static_cast<unsigned char>(code_[at_])) != 0;
                next(1);
            }
        }
    }

    const std::vector<LinedText>& all() const { return all_; }

private:
    bool startsWith(const std::string& words) const { return code_.compare(at_, words.size(), words) == 0; }

    void next(std::size_t n)
    {
        for (; n > 0 && at_ < code_.size(); --n)
        {
            line_ += code_[at_++] == '\n';
        }
    }

    void skipTo(const std::string& end)
    {
        next(std::min(code_.find(end, at_ + 2), code_.size()) - at_);
        next(end == "\n" ? 0 : end.size());
    }

    LinedText& literal()
    {
        if (!isOpen_)
        {
            all_.emplace_back();
            isOpen_ = true;
        }
        return all_.back();
    }

    void raw()
    {
        const std::size_t open = code_.find('(', at_);
        const std::string end = ")" + code_.substr(at_ + 2, open - at_ - 2) + "\"";
        const std::size_t last = std::min(code_.find(end, open), code_.size());
        next(open + 1 - at_);
        for (LinedText& text = literal(); at_ < last; next(1))
        {
            text.add(code_[at_], line_);
        }
        next(end.size());
    }

    void ordinary()
    {
        next(1);
        for (LinedText& text = literal(); at_ < code_.size() && code_[at_] != '"';)
        {
            const bool isEscape = code_[at_] == '\\';
            const char c = isEscape && at_ + 1 < code_.size() ? code_[at_ + 1] : code_[at_];
            text.add(isEscape && (c == 'n' || c == 't') ? ' ' : c, line_);
            next(isEscape ? 2 : 1);
        }
        next(1);
    }

    const std::string& code_;
    std::size_t at_ = 0;
    int line_ = 1;
    bool isOpen_ = false; ///< a literal that the next one continues
    std::vector<LinedText> all_;
};

/// A document without the names of files, and without the glossary, which has what is not to be written.
LinedText document(const std::string& content)
{
    static const std::regex file(R"([A-Za-z0-9_./-]+\.(md|tsv))");
    LinedText text;
    std::istringstream in(content);
    int number = 0;
    bool isGlossary = false;
    for (std::string line; std::getline(in, line);)
    {
        ++number;
        isGlossary = line.starts_with("## ") ? line == "## Glossary" : isGlossary;
        for (const char c : isGlossary ? std::string() : std::regex_replace(line, file, ""))
        {
            text.add(c, number);
        }
        text.add(' ', number);
    }
    return text;
}

/// The list; a line is `phrase<tab>instead`.
const std::vector<Phrase>& bannedPhrases()
{
    static const std::vector<Phrase> phrases = []
    {
        std::vector<Phrase> all;
        std::ifstream in(source / "tests/structure/bannedPhrases");
        for (std::string line; std::getline(in, line);)
        {
            if (line.empty() || line[0] == '#')
            {
                continue;
            }
            Phrase phrase;
            std::istringstream cells(line);
            std::getline(cells, phrase.words, '\t');
            std::getline(cells, phrase.instead, '\t');
            all.push_back(phrase);
        }
        return all;
    }();
    return phrases;
}

/// One line for each phrase found: file:line, the phrase, what to write.
std::string found(const LinedText& text, const std::string& file)
{
    std::string report;
    for (const Phrase& phrase : bannedPhrases())
    {
        for (const int line : text.linesOf(phrase.words))
        {
            report += file + ":" + std::to_string(line) + ": '" + phrase.words + "'; write '" + phrase.instead + "'\n";
        }
    }
    return report;
}

std::string foundInLiterals(const std::string& code, const std::string& file)
{
    std::string report;
    const Literals literals(code);
    for (const LinedText& literal : literals.all())
    {
        report += found(literal, file);
    }
    return report;
}

TEST(Words, ListHasEachPhraseOnceAndWhatToWrite)
{
    EXPECT_GE(bannedPhrases().size(), 20);
    std::set<std::string> words;
    for (const Phrase& phrase : bannedPhrases())
    {
        EXPECT_TRUE(words.insert(phrase.words).second) << phrase.words << " occurs twice";
        EXPECT_FALSE(phrase.instead.empty()) << phrase.words;
        EXPECT_TRUE(
            std::none_of(phrase.words.begin(), phrase.words.end(), [](unsigned char c) { return std::isupper(c) != 0; })
        ) << phrase.words;
    }
}

TEST(Words, AreFoundInLiteralsAcrossLinesAndNotInComments)
{
    const std::string code =
        "// somebody\nconst char c = '\"';\nf(\"What\\n\"\n  \"SomeBody\"\n  \" says\");\n/* nowhere */";
    EXPECT_EQ(foundInLiterals(code, "a.cpp"), "a.cpp:4: 'somebody'; write 'a user; the passive voice'\n");
    EXPECT_EQ(foundInLiterals("f(\"to and\"\n  \" fro\");", "a.cpp").substr(0, 22), "a.cpp:1: 'to and fro';");
    EXPECT_EQ(
        foundInLiterals("f(\"close inlet\", R\"(\n(of late)\n)\");", "a.cpp").substr(0, 18), "a.cpp:2: 'of late'"
    );
    EXPECT_EQ(foundInLiterals("f(1'000, \"moment\", \"of latex\");", "a.cpp"), "");
}

TEST(Words, AreFoundInDocumentsOutsideTheGlossary)
{
    const std::string text = "# Title\n## Glossary\nof late\n## Next\nforces of\nlate\nsee goes-on-of-late.md\n";
    EXPECT_EQ(found(document(text), "a.md"), "a.md:5: 'of late'; write 'recently'\n");
}

TEST(Words, OfMessagesHelpAndLogsAvoidTheList)
{
    int files = 0;
    for (const std::string folder : {"src", "applications"})
    {
        for (const auto& item : fs::recursive_directory_iterator(source / folder))
        {
            if (item.path().extension() == ".cpp" || item.path().extension() == ".hpp")
            {
                ++files;
                EXPECT_EQ(foundInLiterals(contentOf(item.path()), fs::relative(item.path(), source)), "");
            }
        }
    }
    EXPECT_GT(files, 300);
}

TEST(Words, OfDocumentsAvoidTheList)
{
    std::vector<fs::path> files = {source / "README.md", source / "CONTRIBUTING.md"};
    for (const std::string folder : {"docs", "tutorials", "benchmarks"})
    {
        for (const auto& item : fs::recursive_directory_iterator(source / folder))
        {
            if (item.path().extension() == ".md")
            {
                files.push_back(item.path());
            }
        }
    }
    EXPECT_GT(files.size(), 60);
    for (const auto& file : files)
    {
        EXPECT_EQ(found(document(contentOf(file)), fs::relative(file, source)), "");
    }
}

} // namespace
