// SPDX-License-Identifier: GPL-3.0-or-later
// etc/annotated is what the programs have declared.
#include "CaseDirectory.hpp"
#include "programNames.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <set>

namespace slosh
{
namespace
{

namespace fs = std::filesystem;

/// Each dictionary with the programs that print it.
std::map<std::string, std::set<std::string>> printedDictionaries()
{
    const CaseDirectory folder;
    std::map<std::string, std::set<std::string>> programs;
    const std::regex heading(R"(\n\.SH ENTRIES OF (\S+))");
    for (const std::string& program : programNames())
    {
        const std::string page = folder.succeed(program + " -help-man");
        for (std::sregex_iterator match(page.begin(), page.end(), heading), end; match != end; ++match)
        {
            programs[(*match)[1]].insert(program);
        }
    }
    return programs;
}

TEST(AnnotatedDictionaries, AreThoseOfThePrograms)
{
    const CaseDirectory folder;
    const auto printed = printedDictionaries();
    std::set<std::string> files;
    const fs::path annotated = SLOSH_SOURCE "/etc/annotated";
    for (const auto& item : fs::recursive_directory_iterator(annotated))
    {
        if (item.is_regular_file())
        {
            const std::string file = item.path().lexically_relative(annotated);
            files.insert(file);
            ASSERT_EQ(printed.count(file), 1u) << file;
            std::ifstream in(item.path());
            const std::string text{std::istreambuf_iterator<char>(in), {}};
            for (const std::string& program : printed.at(file))
            {
                EXPECT_EQ(folder.succeed(program + " -help-dict " + file), text)
                    << program << ": write it anew by etc/annotate";
            }
        }
    }
    EXPECT_EQ(files.size(), printed.size());
}

TEST(AnnotatedDictionaries, OfANameThatAProgramDoesNotReadAreRefused)
{
    const CaseDirectory folder;
    const Ended ended = folder.run("sloshSPHFoam -help-dict system/sphScheme");
    EXPECT_EQ(ended.status, 1);
    EXPECT_NE(ended.err.find("did you mean 'system/sphSchemes'?"), std::string::npos) << ended.err;
}

} // namespace
} // namespace slosh
