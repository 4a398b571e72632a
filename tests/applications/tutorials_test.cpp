// SPDX-License-Identifier: GPL-3.0-or-later
// Each tutorial, to its first comparison, and the annotated dictionaries.
#include "CaseDirectory.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <regex>

namespace slosh
{
namespace
{

namespace fs = std::filesystem;

/// The dictionaries of a folder with constant/ and system/ instead of the case's own.
void takeDictionaries(const CaseDirectory& theCase, const fs::path& from)
{
    for (const std::string folder : {"constant", "system"})
    {
        theCase.remove(folder);
        fs::copy(from / folder, theCase.path() / folder, fs::copy_options::recursive);
    }
    if (fs::exists(theCase.path() / "constant/polyMesh"))
    {
        theCase.remove("constant/polyMesh"); // an earlier run's
    }
}

TEST(AnnotatedDictionaries, AreACaseThatRuns)
{
    const CaseDirectory theCase;
    takeDictionaries(theCase, fs::path(SLOSH_SOURCE) / "etc/annotated");
    theCase.edit("system/controlDict", "endTime         20;", "endTime         0.02;");
    theCase.succeed("blockParticles");
    const std::string log = theCase.succeed("sloshSPHFoam");
    EXPECT_EQ(log.find("Not used"), std::string::npos) << log;
    EXPECT_TRUE(fs::exists(theCase.path() / "postProcessing"));
    theCase.succeed("probeSample");
    theCase.succeed("compareSamples");
    const std::string study = theCase.succeed("workPrecision");
    EXPECT_EQ(study.find("failed"), std::string::npos) << study;
    const std::string sweep = theCase.succeed("sloshSweep -only 4");
    EXPECT_NE(sweep.find("[4/4] frequency=1.1_angle=8_density=mls: finished"), std::string::npos) << sweep;
}

TEST(Presets, AreEachIncludedByOneLine)
{
    int presets = 0;
    for (const auto& preset : fs::directory_iterator(fs::path(SLOSH_SOURCE) / "etc/presets"))
    {
        const CaseDirectory theCase;
        theCase.write("system/sphSchemes", "#includeEtc \"presets/" + preset.path().filename().string() + "\"\n");
        theCase.write("system/controlDict", theCase.text("system/controlDict") + "adjustTimeStep yes; maxCo 0.8;\n");
        const std::string etc = std::string("SLOSH_ETC='") + SLOSH_SOURCE + "/etc' ";
        EXPECT_EQ(theCase.run("blockParticles", etc).status, 0);
        const Ended run = theCase.run("sloshSPHFoam", etc);
        EXPECT_EQ(run.status, 0) << run.err;
        EXPECT_NE(run.out.find("density diffusion Fourtakas"), std::string::npos) << run.out;
        EXPECT_EQ(run.out.find("limit of stability"), std::string::npos) << run.out;
        ++presets;
    }
    EXPECT_EQ(presets, 2);
}

class Tutorial : public testing::TestWithParam<std::string>
{
};

/// Until when the comparisons of system/startDict want the run to go.
std::string endOfStart(const CaseDirectory& theCase)
{
    const std::string dict = theCase.text("system/startDict");
    std::smatch end;
    EXPECT_TRUE(std::regex_search(dict, end, std::regex(R"(\n    timeEnd\s+([0-9.]+);)")));
    return end.str(1);
}

TEST_P(Tutorial, RunsToItsFirstComparisonAndKeepsItsBound)
{
    const CaseDirectory theCase;
    takeDictionaries(theCase, fs::path(SLOSH_SOURCE) / "tutorials" / GetParam());
    setenv("SLOSH_ETC", SLOSH_SOURCE "/etc", 0); // for presets
    const std::string end = endOfStart(theCase);
    theCase.write(
        "system/controlDict", theCase.text("system/controlDict") + "endTime " + end + "; writeInterval " + end + ";\n"
    );
    theCase.succeed("blockParticles");
    const std::string log = theCase.succeed("sloshSPHFoam");
    EXPECT_EQ(log.find("Not used"), std::string::npos) << log;
    EXPECT_TRUE(fs::exists(theCase.path() / end / "lagrangian/fluid/positions"));
    theCase.succeed("particlesToVTK");
    EXPECT_TRUE(fs::exists(theCase.path() / "VTK/fluid.vtu.series"));

    const Ended compared = theCase.run("compareSamples -dict system/startDict");
    if ((compared.out + compared.err).find("not compared") != std::string::npos)
    {
        GTEST_SKIP() << compared.out << compared.err; // its record is not there
    }
    EXPECT_EQ(compared.status, 0) << compared.out << compared.err;
}

class StudyOfTutorial : public testing::TestWithParam<std::string>
{
};

/// A study varies the case that its Allrun copies.
TEST_P(StudyOfTutorial, CanBeReadInItsQuickAndItsFullForm)
{
    const fs::path study = fs::path(SLOSH_SOURCE) / "tutorials/workPrecision" / GetParam();
    std::ifstream in(study / "Allrun");
    const std::string allrun(std::istreambuf_iterator<char>(in), {});
    std::smatch made;
    ASSERT_TRUE(std::regex_search(allrun, made, std::regex(R"(makeCase (\S+) )")));
    const CaseDirectory theCase;
    takeDictionaries(theCase, study / made.str(1));
    for (const std::string dict : {"workPrecisionDict", "workPrecisionFullDict"})
    {
        fs::copy(study / "system" / dict, theCase.path() / "system" / dict, fs::copy_options::overwrite_existing);
    }
    std::size_t runs = 0;
    for (const std::string dict : {"workPrecisionDict", "workPrecisionFullDict"})
    {
        const Ended ended = theCase.run(
            "workPrecision -dry-run -dict system/" + dict, std::string("SLOSH_ETC='") + SLOSH_SOURCE + "/etc' "
        );
        EXPECT_EQ(ended.status, 0) << ended.err;
        const std::regex run("particleSpacing=");
        const auto found = static_cast<std::size_t>(
            std::distance(std::sregex_iterator(ended.out.begin(), ended.out.end(), run), std::sregex_iterator())
        );
        EXPECT_GT(found, runs) << ended.out;
        runs = found;
    }
    EXPECT_FALSE(fs::exists(theCase.path() / "postProcessing"));
}

std::vector<std::string> studies()
{
    std::vector<std::string> names;
    for (const auto& item : fs::directory_iterator(fs::path(SLOSH_SOURCE) / "tutorials/workPrecision"))
    {
        if (fs::exists(item.path() / "system/workPrecisionDict"))
        {
            names.push_back(item.path().filename().string());
        }
    }
    return names;
}

INSTANTIATE_TEST_SUITE_P(
    Of, StudyOfTutorial, testing::ValuesIn(studies()), [](const auto& tested) { return tested.param; }
);

std::vector<std::string> tutorials()
{
    std::vector<std::string> names;
    const fs::path all = fs::path(SLOSH_SOURCE) / "tutorials";
    for (const auto& scene : fs::directory_iterator(all))
    {
        if (scene.is_directory())
        {
            for (const auto& item : fs::directory_iterator(scene))
            {
                if (fs::exists(item.path() / "constant/tankProperties"))
                {
                    names.push_back(item.path().lexically_relative(all).string());
                }
            }
        }
    }
    return names;
}

INSTANTIATE_TEST_SUITE_P(
    Of, Tutorial, testing::ValuesIn(tutorials()),
    [](const auto& tested) { return std::regex_replace(tested.param, std::regex("[^A-Za-z0-9]"), "_"); }
);

} // namespace
} // namespace slosh
