// SPDX-License-Identifier: GPL-3.0-or-later
// What `cmake --install` leaves, used from elsewhere.
#include "InstallationFolder.hpp"
#include "installed.hpp"
#include "programNames.hpp"

#include <gtest/gtest.h>

#include <memory>

namespace slosh
{
namespace
{

namespace fs = std::filesystem;

/// One installation for all tests.
class Installation : public testing::Test
{
protected:
    static void SetUpTestSuite() { folder_ = std::make_unique<InstallationFolder>(); }
    static void TearDownTestSuite() { folder_.reset(); }

    static Ended bash(const std::string& script) { return folder_->bash(script); }
    static fs::path prefix() { return folder_->prefix(); }

    static std::unique_ptr<InstallationFolder> folder_;
};

std::unique_ptr<InstallationFolder> Installation::folder_;

TEST_F(Installation, HasEachProgramWithItsManualPageAndItsCompletion)
{
    for (const std::string& program : programNames())
    {
        EXPECT_TRUE(fs::exists(prefix() / "bin" / program)) << program;
        EXPECT_TRUE(fs::exists(prefix() / "share/man/man1" / (program + ".1"))) << program;
        EXPECT_TRUE(fs::exists(prefix() / "share/bash-completion/completions" / program)) << program;
    }
}

TEST_F(Installation, RunsACopiedTutorialThatIncludesAPresetWithOnlyItsProgramsOnThePath)
{
    const Ended ended = bash(R"(
PATH=$PWD/prefix/bin:$PATH
cp -r prefix/share/sloshsph/tutorials/stillTank/still2D copied
cd copied
echo '#includeEtc "presets/smallWaves"' > system/sphSchemes
echo 'endTime 0.01; writeInterval 0.01;' >> system/controlDict
blockParticles
sloshSPHFoam
ls
)");
    EXPECT_EQ(ended.status, 0) << ended.err;
    EXPECT_EQ(ended.err, "");
    EXPECT_NE(ended.out.find("density diffusion Fourtakas"), std::string::npos) << ended.out;
    EXPECT_NE(ended.out.find("\n0.01\n"), std::string::npos) << ended.out;
}

TEST_F(Installation, ItsBashrcPutsItsProgramsOnThePathOnceAndLoadsTheirCompletion)
{
    const Ended ended = bash(R"(
. prefix/share/sloshsph/etc/bashrc
. prefix/share/sloshsph/etc/bashrc
echo "$PATH"
echo "$SLOSH_ETC"
complete -p sloshSPHFoam
)");
    const std::string here = prefix().string();
    EXPECT_EQ(ended.status, 0) << ended.err;
    EXPECT_EQ(
        ended.out, here + "/bin:/usr/bin:/bin\n" + here + "/share/sloshsph/etc\ncomplete -F _sloshsph sloshSPHFoam\n"
    );
}

TEST_F(Installation, RunsTheAllrunOfATutorialWhereItIsAndOfACopyOnceItsBashrcIsSourced)
{
    if (!isInstalled("gnuplot"))
    {
        GTEST_SKIP() << "gnuplot is not installed";
    }
    const std::string tutorial = "prefix/share/sloshsph/tutorials/kernelAccuracy/cao2014";
    const Ended there = bash(tutorial + "/Allrun\n" + tutorial + "/Allclean\n");
    EXPECT_EQ(there.status, 0) << there.out << there.err;
    const Ended copied = bash("cp -r " + tutorial + " kernels\n. prefix/share/sloshsph/etc/bashrc\nkernels/Allrun\n");
    EXPECT_EQ(copied.status, 0) << copied.out << copied.err;
    EXPECT_NE(copied.out.find("/kernels/"), std::string::npos) << copied.out;
}

TEST_F(Installation, StopsTheAllrunOfACopyAtItsFirstLineWhereNoBashrcIsSourced)
{
    const Ended ended = bash("cp -r prefix/share/sloshsph/tutorials/stillTank/still2D lost\nlost/Allrun\n");
    EXPECT_EQ(ended.status, 1);
    EXPECT_NE(ended.err.find("etc/runFunctions"), std::string::npos) << ended.err;
    EXPECT_EQ(ended.err.find("command not found"), std::string::npos) << ended.err;
}

TEST(Package, ScriptsRefuseOneWithoutTheLevelThatAnyProcessorRunsAndAPackageThatIsNotThere)
{
    const CaseDirectory folder;
    const Ended built = folder.run(SLOSH_SOURCE "/etc/buildPackage x86-64-v3", "timeout 20");
    EXPECT_EQ(built.status, 1);
    EXPECT_NE(built.err.find("x86-64 must be among the levels"), std::string::npos) << built.err;
    const Ended tried = folder.run(SLOSH_SOURCE "/etc/tryPackage absent.deb", "timeout 20");
    EXPECT_EQ(tried.status, 1);
    EXPECT_NE(tried.err.find("there is no package 'absent.deb'"), std::string::npos) << tried.err;
}

} // namespace
} // namespace slosh
