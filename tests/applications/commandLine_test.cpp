// SPDX-License-Identifier: GPL-3.0-or-later
// What is made of the programs' tables of options: -help, manual pages, completion.
#include "CaseDirectory.hpp"
#include "installed.hpp"
#include "programNames.hpp"

#include "motion/MotionFunction.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <regex>
#include <set>
#include <sstream>

namespace slosh
{
namespace
{

namespace fs = std::filesystem;

using Lines = std::vector<std::string>;

Lines linesOf(const std::string& text)
{
    Lines lines;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);)
    {
        lines.push_back(line);
    }
    return lines;
}

/// The options that -help lists, with their dashes.
std::set<std::string> optionsIn(const std::string& help)
{
    std::set<std::string> options;
    const std::regex row(R"(  (-\S+) .*)");
    for (const std::string& line : linesOf(help))
    {
        if (std::smatch match; std::regex_match(line, match, row))
        {
            options.insert(match[1]);
        }
    }
    return options;
}

TEST(Help, HasAnExampleOfEachProgramThatRunsBesideTheTutorials)
{
    const CaseDirectory folder;
    for (const std::string tutorial :
         {"rollingTank/roll8deg4rad", "stretchingPatch/cao2014", "workPrecision/patch", "workPrecision/interFoam",
          "kernelAccuracy/cao2014", "swayingTank/response"})
    {
        for (const std::string part : {"constant", "system"})
        {
            const fs::path from = fs::path(SLOSH_SOURCE) / "tutorials" / tutorial / part;
            if (fs::exists(from))
            {
                fs::create_directories(folder.path() / "tutorials" / tutorial);
                fs::copy(from, folder.path() / "tutorials" / tutorial / part, fs::copy_options::recursive);
            }
        }
    }
    // The same 20 s at a spacing for which they take seconds.
    const std::string roll = "tutorials/rollingTank/roll8deg4rad/";
    folder.write(roll + "system/blockParticlesDict", "particleSpacing 0.031;\n");
    folder.write(roll + "constant/kernelProperties", "kernel improvedGaussian; hOverDx 1;\n");

    std::vector<std::string> order = {"blockParticles", "sloshSPHFoam"}; // they make what the others read
    for (const std::string& program : programNames())
    {
        if (std::find(order.begin(), order.end(), program) == order.end())
        {
            order.push_back(program);
        }
    }
    for (const std::string& program : order)
    {
        const Lines help = linesOf(folder.succeed(program + " -help"));
        ASSERT_GE(help.size(), 2u);
        ASSERT_EQ(help[help.size() - 2], "Example:");
        const std::string example = help.back().substr(2);
        EXPECT_EQ(example.rfind(program + " -case ", 0), 0u) << example;
        if ((program == "sloshMonitor" || program == "sloshReport") && !isInstalled("gnuplot"))
        {
            continue;
        }
        // What runs until it is stopped is asked to do so once.
        const std::string once = program == "sloshMonitor" ? " -once" : "";
        const Ended ended = folder.run(example + once, "env -u DISPLAY SLOSH_ETC='" SLOSH_SOURCE "/etc'");
        EXPECT_EQ(ended.status, 0) << example << "\n" << ended.err;
        EXPECT_EQ(ended.out.find("failed"), std::string::npos) << example << "\n" << ended.out;
    }
}

TEST(Help, NamesAmongTheFilesThoseThatAreAnnotatedAndAllOfThem)
{
    const CaseDirectory folder;
    std::set<std::string> named, annotated;
    const std::regex file(R"(system/\w+)");
    for (const std::string& program : programNames())
    {
        const std::string help = folder.succeed(program + " -help");
        const std::string files =
            help.substr(help.find("\nFiles:\n"), help.find("\nExample:") - help.find("\nFiles:\n"));
        for (std::sregex_iterator match(files.begin(), files.end(), file), end; match != end; ++match)
        {
            named.insert(match->str());
        }
    }
    for (const auto& item : fs::directory_iterator(SLOSH_SOURCE "/etc/annotated/system"))
    {
        annotated.insert("system/" + item.path().filename().string());
    }
    EXPECT_EQ(named, annotated);
}

TEST(Help, OfTheSolverListsTheMotionsWithTheirSentences)
{
    const CaseDirectory folder;
    const std::string help = folder.succeed("sloshSPHFoam -help");
    for (const auto& motion : MotionFunction::choices())
    {
        const auto at = help.find("\n  " + std::string(motion.name) + " ");
        ASSERT_NE(at, std::string::npos) << motion.name;
        EXPECT_NE(help.substr(at, help.find('\n', at + 1) - at).find(motion.sentence), std::string::npos)
            << motion.name;
    }
}

TEST(ManualPage, OfEachProgramHasItsOptionsAndItsSections)
{
    const CaseDirectory folder;
    ASSERT_EQ(programNames().size(), 12u);
    for (const std::string& program : programNames())
    {
        const std::string page = folder.succeed(program + " -help-man");
        for (std::string option : optionsIn(folder.succeed(program + " -help")))
        {
            option = std::regex_replace(option, std::regex("-"), "\\-");
            EXPECT_NE(page.find("\n.TP\n\\fB" + option + "\\fR"), std::string::npos) << program << " " << option;
        }
        for (const std::string section :
             {"NAME", "SYNOPSIS", "DESCRIPTION", "OPTIONS", "EXAMPLE", "EXIT STATUS", "ENVIRONMENT", "FILES",
              "SEE ALSO"})
        {
            EXPECT_NE(page.find("\n.SH " + section + "\n"), std::string::npos) << program << " " << section;
        }
    }
}

TEST(ManualPage, OfEachProgramIsReadByGroffWithoutAWarning)
{
    if (!isInstalled("groff"))
    {
        GTEST_SKIP() << "groff is not installed";
    }
    const CaseDirectory folder;
    for (const std::string& program : programNames())
    {
        folder.write("script", "groff -man -Tutf8 -ww '" SLOSH_BIN "/../share/man/man1/" + program + ".1'\n");
        const Ended ended = folder.run("./script", "bash");
        EXPECT_EQ(ended.status, 0) << program;
        EXPECT_EQ(ended.err, "") << program;
        EXPECT_NE(ended.out.find(program), std::string::npos);
    }
}

class Completion : public testing::Test
{
protected:
    void SetUp() override
    {
        if (!isInstalled("bash"))
        {
            GTEST_SKIP() << "bash is not installed";
        }
    }

    /// What bash offers, in the case, at the end of the words, with their quotes; sorted.
    std::set<std::string> at(const std::string& words) const
    {
        case_.write("../" + script(), R"(
PATH=')" SLOSH_BIN R"(':$PATH
. ')" SLOSH_BIN R"(/../share/bash-completion/completions/sloshsph'
COMP_WORDS=()" + words + R"()
COMP_CWORD=$((${#COMP_WORDS[@]} - 1)) COMP_LINE=${COMP_WORDS[*]}
COMP_LINE=${COMP_LINE// : /:} # bash takes a colon for a word
COMP_POINT=${#COMP_LINE}
complete -p "${COMP_WORDS[0]}" > /dev/null || exit 1
_sloshsph "${COMP_WORDS[0]}" "${COMP_WORDS[COMP_CWORD]}" "${COMP_WORDS[COMP_CWORD - 1]}"
[ ${#COMPREPLY[@]} = 0 ] || printf '%s\n' "${COMPREPLY[@]}"
)");
        const Ended ended = case_.run("../" + script(), "bash --norc");
        fs::remove(case_.path().parent_path() / script());
        EXPECT_EQ(ended.status, 0) << words;
        EXPECT_EQ(ended.err, "") << words;
        const Lines lines = linesOf(ended.out);
        return {lines.begin(), lines.end()};
    }

    std::string script() const { return case_.path().filename().string() + ".sh"; }

    CaseDirectory case_;
};

using Offers = std::set<std::string>;

TEST_F(Completion, OffersOfEachProgramTheOptionsThatItsHelpLists)
{
    for (const std::string& program : programNames())
    {
        const Offers options = optionsIn(case_.succeed(program + " -help"));
        EXPECT_GE(options.size(), 3u);
        EXPECT_EQ(at(program + " ''"), options) << program;
        EXPECT_EQ(at(program + " -cas"), Offers{"-case"}) << program;
    }
}

TEST_F(Completion, OffersNoOptionTwice)
{
    EXPECT_EQ(at("sloshSPHFoam -case . -dry-run -").count("-case"), 0u);
    EXPECT_EQ(at("sloshSPHFoam -case . -dry-run -").count("-threads"), 1u);
    EXPECT_EQ(at("sloshSPHFoam -case . -dry-run"), Offers{"-dry-run"});
}

TEST_F(Completion, OffersDirectoriesForACaseAndFilesOfTheCaseForADictionary)
{
    EXPECT_EQ(at("blockParticles -case ''"), (Offers{"constant", "system"}));
    case_.write("tank/system/probesDict", "");
    case_.write("tank/system/peaks/of", "");
    EXPECT_EQ(at("probeSample -case tank -dict sys"), Offers{"system/"});
    EXPECT_EQ(at("probeSample -case tank -dict system/p"), (Offers{"system/peaks/", "system/probesDict"}));
    EXPECT_EQ(at("probeSample -dict system/b"), Offers{"system/blockParticlesDict"});
    EXPECT_EQ(at("probeSample -case absent -dict sys"), Offers{});
}

TEST_F(Completion, OffersTheTimesOfTheCaseInRangesAndLists)
{
    EXPECT_EQ(at("particlesToVTK -time ''"), Offers{});
    for (const std::string time : {"0", "0.5", "0.55", "1"})
    {
        case_.write(time + "/lagrangian/fluid/positions", "");
    }
    EXPECT_EQ(at("particlesToVTK -time ''"), (Offers{"0", "0.5", "0.55", "1"}));
    EXPECT_EQ(at("particlesToVTK -time 0.5"), (Offers{"0.5", "0.55"}));
    EXPECT_EQ(at("particlesToVTK -time 0.5 : 1"), Offers{"1"});
    EXPECT_EQ(at("particlesToVTK -time 1,0.5"), (Offers{"1,0.5", "1,0.55"}));
}

TEST_F(Completion, OffersTheWordsThatAnOptionTakes)
{
    EXPECT_EQ(at("particlesToVTK -frame ''"), (Offers{"inertial", "tank"}));
    EXPECT_EQ(at("particlesToVTK -format c"), Offers{"csv"});
    EXPECT_EQ(at("sloshSPHFoam -threads 1").count("1"), 1u);
    EXPECT_EQ(at("compareSamples -only ''"), Offers{}); // any name
}

} // namespace
} // namespace slosh
