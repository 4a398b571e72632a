// Each tutorial, to its first write, and the annotated dictionaries.
#include "CaseDirectory.hpp"

#include <gtest/gtest.h>

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
}

class Tutorial : public testing::TestWithParam<std::string>
{
};

TEST_P(Tutorial, RunsToItsFirstWrite)
{
    const CaseDirectory theCase;
    takeDictionaries(theCase, fs::path(SLOSH_SOURCE) / "tutorials" / GetParam());
    const std::string control = theCase.text("system/controlDict");
    std::smatch interval;
    ASSERT_TRUE(std::regex_search(control, interval, std::regex(R"(\nwriteInterval\s+([0-9.]+);)")));
    theCase.write("system/controlDict", std::regex_replace(control, std::regex(R"(\nendTime\s+[0-9.]+;)"),
                                                           "\nendTime " + interval.str(1) + ";"));
    theCase.succeed("blockParticles");
    const std::string log = theCase.succeed("sloshSPHFoam");
    EXPECT_EQ(log.find("Not used"), std::string::npos) << log;
    EXPECT_TRUE(fs::exists(theCase.path() / interval.str(1) / "lagrangian/fluid/positions"));
    theCase.succeed("particlesToVTK");
    EXPECT_TRUE(fs::exists(theCase.path() / "VTK/fluid.vtu.series"));
}

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
                if (fs::exists(item.path() / "system/controlDict"))
                {
                    names.push_back(item.path().lexically_relative(all).string());
                }
            }
        }
    }
    return names;
}

INSTANTIATE_TEST_SUITE_P(Of, Tutorial, testing::ValuesIn(tutorials()),
                         [](const auto& tested)
                         { return std::regex_replace(tested.param, std::regex("[^A-Za-z0-9]"), "_"); });

} // namespace
} // namespace slosh
