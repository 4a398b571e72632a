// SPDX-License-Identifier: GPL-3.0-or-later
// The same case by programs that were compiled for other instruction sets.
#include "CaseDirectory.hpp"

#include <gtest/gtest.h>

#include <string>

namespace slosh
{
namespace
{

namespace fs = std::filesystem;

/// A tutorial's case, filled, that ends at `endTime`, its last state written.
void fill(const CaseDirectory& folder, const std::string& tutorial, const std::string& endTime)
{
    for (const std::string part : {"constant", "system"})
    {
        fs::remove_all(folder.path() / part);
        fs::copy(
            fs::path(SLOSH_SOURCE "/tutorials") / tutorial / part, folder.path() / part, fs::copy_options::recursive
        );
    }
    std::string control = folder.text("system/controlDict");
    control += "\nendTime " + endTime + ";\nwriteControl timeStep;\nwriteInterval 50;\n";
    folder.write("system/controlDict", control);
    folder.succeed("blockParticles");
}

class Levels : public testing::Test
{
protected:
    void SetUp() override
    {
        if (!fs::exists(v3))
        {
            GTEST_SKIP() << "NOT TESTED: " << v3
                         << " is not there (cmake --preset x86-64-v3; cmake --build --preset x86-64-v3 --target "
                            "sloshSPHFoam)";
        }
        if (CaseDirectory().run("/lib64/ld-linux-x86-64.so.2 --help").out.find("x86-64-v3 (supported") ==
            std::string::npos)
        {
            GTEST_SKIP() << "NOT TESTED: this processor has no AVX2";
        }
    }

    /// Runs the case with the programs of this build, which are for this machine, and with those for AVX2.
    static void expectTheSameFiles(const std::string& tutorial, const std::string& endTime)
    {
        const CaseDirectory native, avx2;
        fill(native, tutorial, endTime);
        avx2.copyFrom(native);
        native.succeed("sloshSPHFoam -threads 1");
        avx2.succeed(v3 + " -threads 2");
        const auto files = native.tree(), others = avx2.tree();
        std::size_t written = 0;
        for (const auto& [name, content] : files)
        {
            written += name.find("lagrangian") != std::string::npos || name.find("postProcessing") == 0 ? 1 : 0;
            ASSERT_TRUE(others.contains(name)) << name;
            EXPECT_TRUE(others.at(name) == content) << name << " differs";
        }
        for (const auto& [name, content] : others)
        {
            // That of ParaView has the name of the case.
            EXPECT_TRUE(files.contains(name) || fs::path(name).extension() == ".foam") << name;
        }
        EXPECT_GT(written, 20u);
    }

    static inline const std::string v3 = SLOSH_BIN "/../../x86-64-v3/bin/sloshSPHFoam";
};

TEST_F(Levels, OfAvx2AndOfThisMachineGiveTheSameBits)
{
    expectTheSameFiles("rollingTank/roll8deg4rad", "0.3");
    expectTheSameFiles("stillTank/still3D", "0.02");
    if (CaseDirectory().run("/lib64/ld-linux-x86-64.so.2 --help").out.find("x86-64-v4 (supported") == std::string::npos)
    {
        GTEST_SKIP() << "NOT TESTED: AVX-512, which this processor does not have; AVX2 alone gives the same bits";
    }
}

} // namespace
} // namespace slosh
