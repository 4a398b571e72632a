// SPDX-License-Identifier: GPL-3.0-or-later
// What dictionaries can name, each in its source, is listed in CMakeLists.txt: what is not cannot be chosen.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <set>
#include <string>

namespace
{

namespace fs = std::filesystem;

std::string textOf(const fs::path& file)
{
    std::ifstream in(file);
    return {std::istreambuf_iterator<char>(in), {}};
}

/// slosh_choices(<folder> <class> <names>) in CMakeLists.txt, against the constants <class>::Choice of the sources.
TEST(Choices, OfEveryFolderAreListedInCMakeLists)
{
    using Names = std::map<std::string, std::set<std::string>>;
    Names listed, defined;
    static const std::regex list(R"(slosh_choices\((\w+) (\w+)([^)]*)\))"), word(R"(\w+)");
    const std::string build = textOf(fs::path(SLOSH_SOURCE) / "CMakeLists.txt");
    for (std::sregex_iterator match(build.begin(), build.end(), list), end; match != end; ++match)
    {
        const std::string names = (*match)[3];
        listed["src/" + (*match)[1].str() + " " + (*match)[2].str()] = {
            std::sregex_token_iterator(names.begin(), names.end(), word), {}};
    }
    static const std::regex definition(R"-(extern const (\w+)::Choice (\w+) = \{\s*"(\w+)")-");
    for (const auto& item : fs::recursive_directory_iterator(fs::path(SLOSH_SOURCE) / "src"))
    {
        const std::string text = item.path().extension() == ".cpp" ? textOf(item.path()) : "";
        for (std::sregex_iterator match(text.begin(), text.end(), definition), end; match != end; ++match)
        {
            const std::string folder = item.path().parent_path().filename();
            defined["src/" + folder + " " + (*match)[1].str()].insert((*match)[2]);
            EXPECT_EQ((*match)[2], (*match)[3]) << item.path();
        }
    }
    EXPECT_EQ(listed, defined);
    EXPECT_GE(listed.size(), 3u);
}

} // namespace
