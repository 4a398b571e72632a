// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/Tank.hpp"

#include "base/CaseError.hpp"
#include "dictionary/Dictionary.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <sstream>

namespace slosh
{
namespace
{

Tank tankOf(const std::string& text)
{
    return Tank::read(Dictionary::parse(text, "constant/tankProperties"));
}

std::string sectionText(const std::vector<Vec2>& corners)
{
    std::ostringstream text;
    text.precision(17);
    text << "polygon (";
    for (const Vec2& x : corners)
    {
        text << "(" << x.x() << " " << x.y() << ") ";
    }
    text << "); ";
    return text.str();
}

const std::vector<Vec2> chamfered = {{-20, -5}, {-15, -10}, {15, -10}, {20, -5},
                                     {20, 10},  {10, 20},   {-10, 20}, {-20, 10}};
const std::vector<Vec2> angle = {{0, 0}, {4, 0}, {4, 1}, {1, 1}, {1, 3}, {0, 3}};
const std::vector<Vec2> sharp = {{0, 0}, {std::tan(std::numbers::pi / 12), 1}, {-std::tan(std::numbers::pi / 12), 1}};

std::string prismOf(const std::vector<Vec2>& corners, const std::string& rest)
{
    return "type prism; section yz; extent (-2 3); " + sectionText(corners) + rest;
}

/// By points along every side.
double distanceTo(const std::vector<Vec2>& corners, const Vec2& x)
{
    double least = 1e300;
    for (std::size_t i = 0; i < corners.size(); ++i)
    {
        const Vec2 &a = corners[i], &b = corners[(i + 1) % corners.size()];
        for (int k = 0; k <= 400; ++k)
        {
            least = std::min(least, (x - a - k / 400.0 * (b - a)).norm());
        }
    }
    return least;
}

/// By the angle that the polygon subtends.
bool isIn(const std::vector<Vec2>& corners, const Vec2& x)
{
    double turn = 0;
    for (std::size_t i = 0; i < corners.size(); ++i)
    {
        const Vec2 a = corners[i] - x, b = corners[(i + 1) % corners.size()] - x;
        turn += std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
    }
    return std::abs(turn) > std::numbers::pi;
}

TEST(Polygon, KnowsDistanceSideAndNormalWhereverAPointIs)
{
    for (const auto& corners : {chamfered, angle, sharp})
    {
        const Polygon polygon(corners);
        const Vec2 size = polygon.high() - polygon.low();
        for (int i = -6; i < 30; ++i)
        {
            for (int j = -6; j < 30; ++j)
            {
                const Vec2 x = polygon.low() + Vec2((i + 0.37) / 23 * size.x(), (j + 0.41) / 23 * size.y());
                const NearestSide side = polygon.nearest(x);
                ASSERT_NEAR(std::abs(side.distance), distanceTo(corners, x), 3e-3 * size.norm()) << x.transpose();
                ASSERT_EQ(side.distance < 0, isIn(corners, x)) << x.transpose();
                ASSERT_EQ(polygon.contains(x), isIn(corners, x)) << x.transpose();
                // To the surface along the normal, whatever is nearest there.
                EXPECT_NEAR(side.normal.norm(), 1, 1e-12);
                EXPECT_NEAR(polygon.nearest(x - side.distance * side.normal).distance, 0, 1e-12 * size.norm());
            }
        }
    }
}

TEST(Polygon, IsTheSameEitherWayRound)
{
    const Polygon polygon(angle), turned({angle.rbegin(), angle.rend()});
    EXPECT_EQ(polygon.area(), 6);
    EXPECT_EQ(turned.area(), 6);
    EXPECT_EQ(turned.nearest({2, 0.5}).distance, -0.5);
    EXPECT_EQ(turned.nearest({2, 1.25}).normal, Vec2(0, 1));
}

TEST(Polygon, HasTheAreaOfItsPartsToTheLastDigits)
{
    const Polygon polygon(chamfered);
    // A rectangle of 40 x 30 without two triangles of 5 x 5/2 and two of 10 x 10/2.
    EXPECT_NEAR(polygon.area(), 1200 - 25 - 100, 1e-10);
    EXPECT_NEAR(polygon.areaInside({-20, -10}, {20, -5}), 5 * 35, 1e-11);
    EXPECT_NEAR(polygon.areaInside({-20, 10}, {20, 15}), 5 * 35, 1e-11);
    EXPECT_NEAR(polygon.areaInside({0, -100}, {100, 100}), polygon.area() / 2, 1e-10);
    EXPECT_EQ(polygon.areaInside({21, -10}, {30, 10}), 0);
    // What a cut leaves of a section that is not convex may be two pieces.
    const Polygon u({{0, 0}, {5, 0}, {5, 3}, {4, 3}, {4, 1}, {1, 1}, {1, 3}, {0, 3}});
    EXPECT_NEAR(u.areaInside({0, 2}, {5, 3}), 2, 1e-12);
    const auto chords = u.chords(0, 2.5);
    ASSERT_EQ(chords.size(), 2u);
    EXPECT_EQ(chords[0], (std::pair{0.0, 1.0}));
    EXPECT_EQ(chords[1], (std::pair{4.0, 5.0}));
}

TEST(Prism, WhoseSectionIsARectangleIsABox)
{
    const Tank box = tankOf("type box; min (-2 0 1); max (3 4 3); fillDepth 1;");
    const Tank tank = tankOf(prismOf({{4, 1}, {4, 3}, {0, 3}, {0, 1}}, "fillDepth 1;"));
    EXPECT_TRUE(tank.isBox());
    EXPECT_EQ(tank.box().min(), box.box().min());
    EXPECT_EQ(tank.box().max(), box.box().max());
}

TEST(Prism, HasItsSectionInAnyOfThreePlanesAndEndsIn3D)
{
    const std::string triangle = "extent (1 4); polygon ((0 0) (3 0) (0 4)); fillDepth 1; ";
    struct Case
    {
        std::string section;
        int a, b, along;
    };
    for (const auto& [section, a, b, along] : {Case{"xz", 0, 2, 1}, Case{"yz", 1, 2, 0}, Case{"xy", 0, 1, 2}})
    {
        const Tank tank = tankOf("type prism; section " + section + "; " + triangle);
        Vec X;
        X[a] = 1;
        X[b] = 1;
        X[along] = 2.5;
        EXPECT_TRUE(tank.isInside(X)) << section;
        EXPECT_NEAR(tank.distanceToWall(X), 1, 1e-12); // of the triangle 3, 4, 5 it is the centre
        X[along] = 1.25;
        EXPECT_NEAR(tank.distanceToWall(X), 0.25, 1e-12);
        EXPECT_NEAR(tank.nearestWall(X).normal[along], 1, 1e-12);
        X[a] = 3; // beyond the slanted side, (4 3)/5, and the end
        X[b] = 4;
        X[along] = 0;
        EXPECT_FALSE(tank.isInside(X));
        const NearestSurface beyond = tank.nearestWall(X);
        EXPECT_NEAR(beyond.distance, -std::hypot(12.0 / 5, 1), 1e-12);
        EXPECT_NEAR(beyond.normal[a] / beyond.normal[along], -4.0 / 5 * 12 / 5, 1e-12);
    }
    const Tank slice = tankOf("type prism; section yz; plane yz; " + triangle);
    EXPECT_NEAR(slice.distanceToWall({1.01, 1, 1}), 1, 1e-12);
    EXPECT_TRUE(slice.isInside({-7, 1, 1}));
    EXPECT_EQ(slice.thickness(), 3);
}

TEST(Prism, IsFilledToTheSameSurfaceByDepthLevelOrVolume)
{
    // Up to z = -5 there are 35 x 5 m^2, of a metre more 40; the extent is 5 m.
    for (const char* fill : {"fillDepth 6;", "fillLevel -4;", "fillVolume 1075;"})
    {
        const Tank tank = tankOf(prismOf(chamfered, fill));
        EXPECT_NEAR(tank.fill().level(), -4, 1e-12) << fill;
        EXPECT_NEAR(tank.fill().volume(), 1075, 1e-9) << fill;
    }
    // A wedge of 30 degrees holds tan 15 z^2.
    const Tank wedge = tankOf(prismOf(sharp, "fillVolume 0.1;"));
    const double slope = Polygon(sharp).high().x();
    EXPECT_NEAR(wedge.fillDepth(), std::sqrt(0.1 / 5 / slope), 1e-12);
    EXPECT_NEAR(tankOf(prismOf(sharp, "fillDepth 1;")).fill().volume(), 5 * slope, 1e-12);
}

TEST(Prism, LosesToABodyWhatIsInsideBoth)
{
    // In the chamfer the body has the triangle -20 .. -15 only.
    const std::string body = "geometry { body { type searchableBox; min (-2 -20 -10); max (3 -15 -5); } } ";
    EXPECT_NEAR(tankOf(prismOf(chamfered, "fillLevel -5; " + body)).fill().volume(), 5 * (175 - 12.5), 1e-9);
    EXPECT_THROW(
        tankOf(prismOf(
            chamfered, "fillLevel -5; geometry { body { type searchableBox; min (-2 -20 -10); "
                       "max (3 -18 -8); } }"
        )),
        CaseError
    );
}

TEST(Prism, HasTheMeanDepthOfItsLiquid)
{
    // Of a wedge the centroid is a third of the depth below the surface, of a box half.
    const auto depth = [](double d) { return d; };
    EXPECT_NEAR(tankOf(prismOf(sharp, "fillDepth 0.9;")).meanOverDepth(depth), 0.3, 1e-6);
    EXPECT_NEAR(tankOf("type box; min (0 0 0); max (1 1 1); fillDepth 0.9;").meanOverDepth(depth), 0.45, 1e-6);
}

TEST(Prism, HasTheFrequenciesOfTheBoxUnderItsSurfaceAndSaysWhetherTheyAreItsOwn)
{
    const auto first = [](const Tank& tank) { return tank.naturalFrequencies(9.81, 1).front(); };
    const auto of = [](double breadth, double depth)
    {
        const double k = std::numbers::pi / breadth;
        return std::sqrt(9.81 * k * std::tanh(k * depth));
    };
    const std::string slice = "plane yz; ";
    const Tank half = tankOf(slice + prismOf(chamfered, "fillLevel 15;"));
    EXPECT_NEAR(first(half), of(30, 25), 1e-9); // between the upper chamfers
    EXPECT_FALSE(half.liquidIsBox());
    // Chamfered at its roof only, dry there.
    const Tank roof = tankOf(slice + prismOf({{0, 0}, {4, 0}, {4, 2}, {3, 3}, {1, 3}, {0, 2}}, "fillDepth 1;"));
    EXPECT_NEAR(first(roof), of(4, 1), 1e-12);
    EXPECT_TRUE(roof.liquidIsBox());
    // Two surfaces, and one that is no rectangle.
    const Tank u =
        tankOf(slice + prismOf({{0, 0}, {5, 0}, {5, 3}, {4, 3}, {4, 1}, {1, 1}, {1, 3}, {0, 3}}, "fillDepth 2;"));
    EXPECT_TRUE(u.naturalFrequencies(9.81, 3).empty());
    const Tank upright = tankOf("type prism; section xy; extent (0 2); polygon ((0 0) (3 0) (0 4)); fillDepth 1;");
    EXPECT_TRUE(upright.naturalFrequencies(9.81, 3).empty());
    EXPECT_FALSE(upright.liquidIsBox());
}

TEST(Prism, OnAVerticalReachesFromItsLowestToItsHighestPoint)
{
    const Tank tank = tankOf(prismOf(chamfered, "fillDepth 6;"));
    EXPECT_EQ(tank.verticalExtent({0, 0, 0}), (std::pair{-10.0, 20.0}));
    EXPECT_EQ(tank.verticalExtent({0, 18, 0}), (std::pair{-7.0, 12.0}));
    EXPECT_EQ(tank.verticalExtent({0, 30, 0}), (std::pair{-10.0, -10.0}));
}

TEST(Prism, RefusesWhatIsNoPrismWithFileLineAndWhatIsAllowed)
{
    const auto message = [](const std::string& text)
    {
        try
        {
            tankOf("type prism;\n" + text + "\nfillDepth 0.1;");
        }
        catch (const CaseError& error)
        {
            return std::string(error.what());
        }
        return std::string("accepted");
    };
    const auto expect = [&](const std::string& text, const std::vector<std::string>& fragments)
    {
        const std::string said = message(text);
        for (const auto& fragment : fragments)
        {
            EXPECT_NE(said.find(fragment), std::string::npos) << fragment << " in: " << said;
        }
    };
    const std::string place = "constant/tankProperties:";
    const std::string yz = "section yz; extent (0 1);\n", good = "polygon ((0 0) (1 0) (0 1));";
    EXPECT_EQ(message(yz + good), "accepted");
    expect(yz + "polygon ((0 0) (1 0));", {place + "3: polygon has 2 corners; expected at least 3"});
    expect(yz + "polygon ((0 0) (1 0) (1 1) (1 0));", {place + "3: polygon has the corner (1 0) twice"});
    expect(yz + "polygon ((0 0) (1 1) (2 2));", {place + "3: polygon has no area: its corners lie on one line"});
    expect(
        yz + "polygon ((0 0) (1 0) (2 0) (0 1));",
        {place + "3: polygon has the corner (1 0) on the straight line through its neighbours; omit it"}
    );
    expect(yz + "polygon ((0 0) (3 0) (1 0) (0 1));", {"(3 0) on the straight line"}); // there and back
    expect(
        yz + "polygon ((0 0) (1 1) (1 0) (0 1));",
        {place + "3: polygon intersects itself: the side (0 0) to (1 1) meets the side (1 0) to (0 1)"}
    );
    expect(yz + "polygon ((0 0) (4 0) (4 3) (2 0) (0 3));", {"intersects itself", "(0 0) to (4 0)"}); // it touches
    expect(yz + "polygon ((0 0 0) (1 0 0) (0 1 0));", {"expected a list ((a b) ...) of points [m]", place + "3"});
    expect(yz, {"entry 'polygon' not found in dictionary \"constant/tankProperties\""});
    expect("section yz; " + good + "\nextent (1 1);", {"extent is not a pair of increasing numbers", place + "3"});
    expect("section yz; " + good + "\nextent (1 2 3);", {"extent is not a pair of increasing numbers", place + "3"});
    expect("section zx; extent (0 1);" + good, {place + "2: unknown section 'zx'", "xz", "yz", "xy"});
    expect(
        "section xz; plane yz; extent (0 1);" + good,
        {place + "2: section is xz and plane is yz; expected the same in 2D"}
    );
    expect("section xy; plane xz; extent (0 1);" + good, {"section is xy and plane is xz"});
    expect(yz + good + "min (0 0 0);", {"'min'"});
    expect(yz + "polygon ((0 0) (1 0) (0 1)); fillLevel 2;", {"fillLevel"});
    EXPECT_THROW(tankOf("type prism; " + yz + good + "fillVolume 0.51;"), CaseError);
    EXPECT_THROW(
        tankOf(
            "type prism; " + yz + good + "liquid { drop { type searchableBox; min (0 0.4 0.4); max (1 0.6 0.6); } }"
        ),
        CaseError
    );
}

} // namespace
} // namespace slosh
