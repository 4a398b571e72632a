// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/Tank.hpp"

#include "base/CaseError.hpp"
#include "dictionary/Dictionary.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace slosh
{
namespace
{

constexpr double pi = std::numbers::pi;
const std::string drum = "type disc; plane yz; centre (77 0.2 0.5); radius 0.5; extent (-1 1); ";

Tank tankOf(const std::string& text)
{
    return Tank::read(Dictionary::parse(text, "constant/tankProperties"));
}

TEST(Disc, KnowsDistanceSideAndNormalWhereverAPointIs)
{
    const Tank tank = tankOf(drum + "fillDepth 0.5;");
    for (const double r : {0.0, 0.1, 0.499, 0.5, 0.7, 3.0})
    {
        for (double angle = 0.1; angle < 2 * pi; angle += 0.7)
        {
            const Vec out(0, std::cos(angle), std::sin(angle));
            const Vec X = Vec(9, 0.2, 0.5) + r * out;
            EXPECT_NEAR(tank.distanceToWall(X), 0.5 - r, 1e-14);
            const NearestSurface wall = tank.nearestWall(X);
            EXPECT_NEAR(wall.normal.norm(), 1, 1e-14);
            if (r > 0)
            {
                EXPECT_NEAR((wall.normal + out).norm(), 0, 1e-13);
            }
            if (r != 0.5)
            {
                EXPECT_EQ(tank.isInside(X), r < 0.5);
            }
        }
    }
}

TEST(Disc, IsFilledToTheSameSurfaceByDepthLevelOrVolume)
{
    const double share = std::acos(0.6) - 0.6 * 0.8; // segment of height 0.4 R, over R^2
    std::ostringstream byVolume;
    byVolume.precision(17);
    byVolume << "fillVolume " << 2 * 0.25 * share << ";";
    for (const std::string& fill : {std::string("fillDepth 0.2;"), std::string("fillLevel 0.2;"), byVolume.str()})
    {
        const Tank tank = tankOf(drum + fill);
        EXPECT_NEAR(tank.fill().level(), 0.2, 1e-12) << fill;
        EXPECT_NEAR(tank.fill().volume(), 2 * 0.25 * share, 1e-14) << fill;
    }
    EXPECT_NEAR(tankOf(drum + "fillDepth 0.5;").fill().volume(), pi / 4, 1e-15);
    EXPECT_NEAR(tankOf(drum + "fillDepth 1;").fill().volume(), pi / 2, 1e-15);
    EXPECT_THROW(tankOf(drum + "fillDepth 1.1;"), CaseError);
    EXPECT_THROW(tankOf(drum + "fillVolume 1.5709;"), CaseError);
}

TEST(Disc, HasChordsOutlineAndTheFrequenciesOfTheBoxUnderItsSurface)
{
    const Tank tank = tankOf(drum + "fillDepth 0.2;");
    EXPECT_NEAR(tank.verticalExtent({0, 0.5, 0}).first, 0.1, 1e-14);
    EXPECT_NEAR(tank.verticalExtent({0, 0.5, 0}).second, 0.9, 1e-14);
    const double k = pi / 0.8;
    EXPECT_NEAR(tank.naturalFrequencies(9.81, 1).front(), std::sqrt(9.81 * k * std::tanh(k * 0.2)), 1e-7);
    EXPECT_FALSE(tank.liquidIsBox());
    EXPECT_EQ(tank.walls().description(), "a disc");
    for (const Vec& X : tank.walls().outline().corners)
    {
        EXPECT_EQ(X.x(), 0); // the middle of the slice
        EXPECT_NEAR(tank.distanceToWall(X), 0, 1e-3);
    }
    const DrawnSection section = *tank.walls().section(0.01);
    EXPECT_NEAR(section.polygon.area(), pi / 4, 1e-14);
    for (std::size_t i = 0; i < section.polygon.corners().size(); ++i)
    {
        const Vec2 a = section.polygon.corner(i), b = section.polygon.corner(i + 1);
        EXPECT_LT(std::abs((a - Vec2(0.2, 0.5)).norm() - 0.5), 1e-4); // dx/100
        EXPECT_LT(std::abs(((a + b) / 2 - Vec2(0.2, 0.5)).norm() - 0.5), 1e-4);
    }
}

TEST(Disc, IsOfTwoDimensionsOnly)
{
    try
    {
        tankOf("type disc; centre (0 0 1); radius 1; extent (-1 1); fillDepth 1;");
        FAIL();
    }
    catch (const CaseError& error)
    {
        EXPECT_NE(std::string(error.what()).find("type is disc, which is a shape of 2D"), std::string::npos)
            << error.what();
    }
    EXPECT_THROW(tankOf("type disc; plane yz; centre (0 0 1); radius -1; extent (-1 1); fillDepth 1;"), CaseError);
    EXPECT_THROW(tankOf("type disc; plane yz; centre (0 0 1); radius 1; extent (1 1); fillDepth 1;"), CaseError);
}

} // namespace
} // namespace slosh
