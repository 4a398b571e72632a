// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/Scene.hpp"

#include "base/CaseError.hpp"
#include "base/writeFile.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <unistd.h>

namespace slosh
{
namespace
{

namespace fs = std::filesystem;

/// A case that sways, with `sphSchemes`.
class SceneOfACase : public testing::Test
{
protected:
    void SetUp() override
    {
        root_ = fs::temp_directory_path() / ("slosh.scene." + std::to_string(::getpid()));
        fs::create_directories(root_ / "system");
        write("constant/tankProperties", "type box; plane xz; min (0 0 0); max (1 0.1 1); fillDepth 0.4;");
        write("constant/g", "dimensions [0 1 -2 0 0 0 0]; value (0 0 -9.81);");
        write("constant/fluidProperties", "rho0 998; viscosity { type none; }");
        write("constant/kernelProperties", "kernel wendlandC2; hOverDx 1.5;");
        write(
            "constant/dynamicMeshDict", "solidBodyMotionFunction linearMotion; linearMotionCoeffs { velocity (1 0 0); }"
        );
    }
    void TearDown() override { fs::remove_all(root_); }
    void write(const std::string& file, const std::string& text) const { writeFile(root_ / file, text); }
    Scene read(double spacing) const { return Scene::read(Case(root_), spacing); }

    fs::path root_;
};

TEST_F(SceneOfACase, IsWhatItsConstantSays)
{
    const Scene scene = read(0.02);
    EXPECT_EQ(scene.tank.fillDepth(), 0.4);
    EXPECT_EQ(scene.gravity, Vec(0, 0, -9.81));
    EXPECT_DOUBLE_EQ(scene.kernel.smoothingLength(), 0.03);
    EXPECT_EQ(scene.motion->at(2).c, Vec(2, 0, 0));
    EXPECT_NEAR(scene.equationOfState.c0, 10 * (std::sqrt(9.81 * 0.4) + 1), 1e-9);
    EXPECT_FALSE(scene.wallSuction);

    const Scene finer = scene.withSpacing(0.01);
    EXPECT_EQ(finer.particleSpacing, 0.01);
    EXPECT_EQ(finer.kernel.smoothingLength(), read(0.01).kernel.smoothingLength()); // to the bit
    const Scene still = scene.atRest(Vec(0, 0, -1));
    EXPECT_TRUE(still.motion->isStationary());
    EXPECT_EQ(still.gravity, Vec(0, 0, -1));
    EXPECT_EQ(still.equationOfState.c0, scene.equationOfState.c0);
}

TEST_F(SceneOfACase, KnowsWhetherWallsMayPullAndRefusesWhatItDoesNotKnowOfThem)
{
    write("system/sphSchemes", "wall { type Adami; suction yes; }");
    EXPECT_TRUE(read(0.02).wallSuction);
    write("system/sphSchemes", "wall { type Adami; sucktion yes; }");
    EXPECT_THROW(read(0.02), CaseError);
    write("system/sphSchemes", "wall { type Adam; }");
    EXPECT_THROW(read(0.02), CaseError);
}

} // namespace
} // namespace slosh
