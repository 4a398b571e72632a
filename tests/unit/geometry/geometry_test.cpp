// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/Tank.hpp"

#include "base/CaseError.hpp"
#include "dictionary/Dictionary.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace slosh
{
namespace
{

Tank tankOf(const std::string& text)
{
    return Tank::read(Dictionary::parse(text, "constant/tankProperties"));
}

const std::string rolling = "type box; plane yz; min (-0.5 -0.46 0); max (0.5 0.46 0.62); ";
const std::string cube = "type box; min (0 0 0); max (0.6 0.5 0.4); ";
const std::string baffle = "geometry { baffle { type searchableBox; min (-1 -0.05 0); max (1 0.05 0.1); } } ";

TEST(Tank, HasTheFrequenciesOfCaoEtAl)
{
    const std::vector<double> omega = tankOf(rolling + "fillDepth 0.155;").naturalFrequencies(9.81, 3);
    ASSERT_EQ(omega.size(), 3u);
    for (int n = 1; n <= 3; ++n)
    {
        const double k = n * std::acos(-1.0) / 0.92;
        EXPECT_NEAR(omega[n - 1], std::sqrt(9.81 * k * std::tanh(k * 0.155)), 1e-12);
    }
    EXPECT_NEAR(omega[0], 4.03008, 1e-5); // sqrt(g k tanh(k D)), by hand
}

TEST(Tank, SortsTheFrequenciesOfABoxByMagnitude)
{
    const std::vector<double> omega = tankOf(cube + "fillDepth 0.2;").naturalFrequencies(9.81, 4);
    const auto of = [](double m, double n)
    {
        const double k = std::acos(-1.0) * std::hypot(m / 0.6, n / 0.5);
        return std::sqrt(9.81 * k * std::tanh(k * 0.2));
    };
    EXPECT_NEAR(omega[0], of(1, 0), 1e-12);
    EXPECT_NEAR(omega[1], of(0, 1), 1e-12);
    EXPECT_NEAR(omega[2], of(1, 1), 1e-12);
    EXPECT_NEAR(omega[3], of(2, 0), 1e-12);
}

TEST(Tank, FillsToTheSameSurfaceByDepthLevelOrVolume)
{
    const std::string raised = "type box; plane xz; min (0 0 1); max (2 0.5 2); ";
    for (const char* fill : {"fillDepth 0.25;", "fillLevel 1.25;", "fillVolume 0.25;"})
    {
        const Tank tank = tankOf(raised + fill);
        EXPECT_NEAR(tank.fillDepth(), 0.25, 1e-14) << fill;
        EXPECT_NEAR(tank.fill().volume(), 0.25, 1e-14) << fill;
    }
}

TEST(Tank, TakesTheBodyOutOfTheLiquid)
{
    const Tank byDepth = tankOf(rolling + baffle + "fillDepth 0.2;");
    EXPECT_NEAR(byDepth.fill().volume(), 0.92 * 0.2 - 0.1 * 0.1, 1e-14);
    const Tank byVolume = tankOf(rolling + baffle + "fillVolume 0.174;");
    EXPECT_NEAR(byVolume.fill().level(), 0.2, 1e-12);
}

TEST(Tank, MeasuresTheDistanceToTheNearestWallOrBody)
{
    const Tank tank = tankOf(rolling + baffle + "fillDepth 0.2;");
    EXPECT_NEAR(tank.distanceToWall(Vec(0, -0.4, 0.3)), 0.06, 1e-15);
    EXPECT_NEAR(tank.distanceToWall(Vec(7, 0, 0.15)), 0.05, 1e-15) << "the empty direction is ignored";
    EXPECT_NEAR(tank.distanceToWall(Vec(0, 0.08, 0.14)), 0.05, 1e-15) << "from the baffle's edge";
    EXPECT_LT(tank.distanceToWall(Vec(0, 0, 0.05)), 0);
    EXPECT_LT(tank.distanceToWall(Vec(0, 0.5, 0.3)), 0);
    EXPECT_NEAR(tank.distanceToWall(Vec(0, 0.46, 0.3)), 0, 1e-15);
}

TEST(Tank, PointsFromTheNearestWallIntoTheLiquid)
{
    const Tank tank = tankOf(rolling + baffle + "fillDepth 0.155;");
    const double h = 1e-6;
    for (const Vec& X :
         {Vec(0, -0.45, 0.3), Vec(0, 0.47, 0.3), Vec(0, 0.2, 0.01), Vec(0, 0.2, 0.6), Vec(0, 0.06, 0.12),
          Vec(0, 0.02, 0.09), Vec(0, -0.045, 0.06)})
    {
        const NearestSurface wall = tank.nearestWall(X);
        for (const int d : {1, 2})
        {
            const double slope =
                (tank.distanceToWall(X + h * Vec::Unit(d)) - tank.distanceToWall(X - h * Vec::Unit(d))) / (2 * h);
            EXPECT_NEAR(wall.normal[d], slope, 1e-6) << X.transpose();
        }
        EXPECT_EQ(wall.normal.x(), 0);
        EXPECT_EQ(tank.isInside(X), wall.distance >= 0) << X.transpose();
        EXPECT_TRUE(tank.isInside(X) == tank.isInside(X + Vec(99, 0, 0)));
        EXPECT_NEAR(wall.normal.norm(), 1, 1e-12);
    }
}

TEST(Tank, HoldsLiquidInRegionsWithTheirOwnSurfaces)
{
    const Tank dam = tankOf("type box; plane xz; min (0 0 0); max (1.61 0.15 0.6); "
                            "liquid { column { type searchableBox; min (0 0 0); max (0.6 9 0.3); } }");
    EXPECT_NEAR(dam.fill().volume(), 0.6 * 0.15 * 0.3, 1e-15);
    EXPECT_EQ(dam.fillDepth(), 0.3);
    EXPECT_FALSE(dam.fill().fromWallToWall());
    EXPECT_TRUE(dam.fill().hasOneSurface());
    EXPECT_NEAR(dam.fill().depthAt(Vec(0.3, 0.07, 0.1)), 0.2, 1e-15);
    EXPECT_FALSE(dam.fill().contains(Vec(0.61, 0.07, 0.1)));

    const std::string drops = "liquid { pool { type searchableBox; min (0 0 0); max (0.6 0.5 0.1); } "
                              "drop { type searchableSphere; centre (0.3 0.25 0.3); radius 0.05; } }";
    const Tank two = tankOf(cube + drops);
    const double pi = std::acos(-1.0);
    EXPECT_NEAR(two.fill().volume(), 0.6 * 0.5 * 0.1 + 4.0 / 3.0 * pi * std::pow(0.05, 3), 1e-15);
    EXPECT_FALSE(two.fill().hasOneSurface());
    EXPECT_NEAR(two.fill().depthAt(Vec(0.3, 0.25, 0.3)), 0.05, 1e-15);
    EXPECT_NEAR(two.fill().depthAt(Vec(0.3, 0.25, 0.04)), 0.06, 1e-15);
    EXPECT_FALSE(two.fill().contains(Vec(0.3, 0.25, 0.36)));
}

TEST(Tank, TakesASphereInASliceForADisc)
{
    const Tank slice = tankOf("type box; plane xz; min (-2 0 -2); max (2 0.5 2); "
                              "liquid { patch { type searchableSphere; centre (0 99 0); radius 1; } }");
    EXPECT_NEAR(slice.fill().volume(), std::acos(-1.0) * 0.5, 1e-14);
    EXPECT_TRUE(slice.fill().contains(Vec(0.7, 0.25, 0.7)));
    EXPECT_FALSE(slice.fill().contains(Vec(0.8, 0.25, 0.7)));
}

TEST(Tank, RefusesRegionsOfLiquidThatCannotBe)
{
    const auto with = [](const std::string& regions) { return tankOf(cube + "liquid { " + regions + " }"); };
    const std::string pool = "pool { type searchableBox; min (0 0 0); max (0.6 0.5 0.1); } ";
    EXPECT_THROW(with(""), CaseError);
    EXPECT_THROW(with("drop { type searchableSphere; centre (0.3 0.25 0.38); radius 0.05; }"), CaseError);
    EXPECT_THROW(with(pool + "other { type searchableBox; min (0.1 0.1 0.05); max (0.2 0.2 0.3); }"), CaseError);
    EXPECT_THROW(tankOf(cube + "fillDepth 0.1; liquid { " + pool + "}"), CaseError);
    EXPECT_THROW(
        tankOf(
            cube + "geometry { baffle { type searchableBox; min (0.2 0 0); max (0.3 0.5 0.2); } } liquid { " + pool +
            "}"
        ),
        CaseError
    );
    EXPECT_NO_THROW(with(pool));
}

TEST(Tank, RefusesWhatCannotBe)
{
    for (const std::string& wrong :
         {rolling + "fillDepth 0.63;", rolling + "fillDepth -0.1;", rolling + "fillDepth 0.1; fillLevel 0.1;", rolling,
          std::string("type box; min (0 0 0); max (0 1 1); fillDepth 0.1;"), cube + "fillDepth 0.1; fillDeep 1;",
          rolling + "fillDepth 0.2; geometry { b { type searchableBox; min (-1 2 0); max (1 3 1); } }",
          rolling + "fillDepth 0.2; geometry { b { type searchableBlob; } }", std::string("type can; fillDepth 1;"),
          std::string("type box; plane xy; min (0 0 0); max (1 1 1); fillDepth 0.1;")})
    {
        EXPECT_THROW(tankOf(wrong), CaseError) << wrong;
    }
}

} // namespace
} // namespace slosh
