// SPDX-License-Identifier: GPL-3.0-or-later
// Our laws of motion beside OpenFOAM's own: its interFoam cases, their points moved by moveDynamicMesh.
#include "installed.hpp"
#include "interFoamCase.hpp"

#include "case/foamFile.hpp"
#include "dictionary/Dictionary.hpp"
#include "motion/SolidBodyMotion.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

namespace slosh
{
namespace
{

struct MovedCase
{
    std::string name;
    double deltaT; ///< of six steps, which must not be beyond the end of a table
};

void PrintTo(const MovedCase& moved, std::ostream* out)
{
    *out << moved.name << ", deltaT " << moved.deltaT;
}

class InterFoamMotion : public testing::TestWithParam<MovedCase>
{
protected:
    void SetUp() override
    {
        if (const std::string missing = missingForInterFoamCases(); !missing.empty())
        {
            GTEST_SKIP() << missing;
        }
    }
};

TEST_P(InterFoamMotion, MovesEveryPointAsMoveDynamicMeshDoes)
{
    constexpr int steps = 6;
    const auto& [name, deltaT] = GetParam();
    const InterFoamCase theCase(name);
    theCase.write(
        "system/controlDict", "FoamFile { version 2.0; format ascii; class dictionary; object controlDict; }\n"
                              "startFrom startTime; startTime 0; stopAt endTime; endTime " +
                                  std::to_string(steps * deltaT) + "; deltaT " + std::to_string(deltaT) +
                                  ";\nwriteControl timeStep; writeInterval 1; writeFormat binary; writePrecision 17;\n"
    );
    succeedInShell(theCase, "blockMesh > /dev/null; moveDynamicMesh > /dev/null");
    const std::vector<Vec> X = readVectorField(theCase.path(), "constant/polyMesh/points");
    const auto motion = SolidBodyMotion::read(
        Dictionary::read(theCase.path() / "constant/dynamicMeshDict", "constant/dynamicMeshDict"), theCase.path()
    );
    BoundingBox box;
    for (const Vec& point : X)
    {
        box.extend(point);
    }

    int times = 0;
    double largest = 0, moved = 0;
    for (const auto& item : std::filesystem::directory_iterator(theCase.path()))
    {
        const std::string time = item.path().filename().string();
        if (!std::filesystem::exists(item.path() / "uniform/time"))
        {
            continue;
        }
        ++times;
        const std::vector<Vec> x = readVectorField(theCase.path(), time + "/polyMesh/points", std::ssize(X));
        const RigidState state = motion->at(
            Dictionary::read(item.path() / "uniform/time", time + "/uniform/time").scalar("value", unit::second)
        );
        for (std::size_t i = 0; i < X.size(); ++i)
        {
            largest = std::max(largest, (state.pointToInertial(X[i]) - x[i]).norm());
            moved = std::max(moved, (x[i] - X[i]).norm());
        }
    }
    EXPECT_EQ(times, steps);
    const double size = box.sizes().maxCoeff();
    std::printf(
        "%s: %zu points moved by up to %.3g m, apart by up to %.2g of the tank's %.3g m\n", name.c_str(), X.size(),
        moved, largest / size, size
    );
    EXPECT_GT(moved, 1e-3 * size);
    EXPECT_LT(largest, 1e-12 * size);
}

// Of the table the first step and the last are in its outermost intervals, where a row is missing.
INSTANTIATE_TEST_SUITE_P(
    Of, InterFoamMotion,
    testing::Values(
        MovedCase{"sloshingTank2D", 6.6}, MovedCase{"sloshingTank2D3DoF", 0.77}, MovedCase{"sloshingTank3D", 1.31},
        MovedCase{"sloshingTank3D3DoF", 5.3}, MovedCase{"sloshingTank3D6DoF", 0.31},
        MovedCase{"sloshingTank3D6DoF", 6.62}, MovedCase{"sloshingCylinder", 0.077}, MovedCase{"testTubeMixer", 0.113}
    ),
    [](const auto& tested)
    { return tested.param.name + "_" + std::to_string(std::lround(1000 * tested.param.deltaT)) + "ms"; }
);

} // namespace
} // namespace slosh
