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
        EXPECT_NEAR(omega[static_cast<std::size_t>(n - 1)], std::sqrt(9.81 * k * std::tanh(k * 0.155)), 1e-12);
    }
    EXPECT_NEAR(omega[0], 4.03008, 1e-5); // REFERENCES 2.4
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
        EXPECT_NEAR(tank.fillVolume(), 0.25, 1e-14) << fill;
    }
}

TEST(Tank, TakesTheBodyOutOfTheLiquid)
{
    const Tank byDepth = tankOf(rolling + baffle + "fillDepth 0.2;");
    EXPECT_NEAR(byDepth.fillVolume(), 0.92 * 0.2 - 0.1 * 0.1, 1e-14);
    const Tank byVolume = tankOf(rolling + baffle + "fillVolume 0.174;");
    EXPECT_NEAR(byVolume.fillLevel(), 0.2, 1e-12);
}

TEST(Tank, MeasuresTheDistanceToTheNearestWallOrBody)
{
    const Tank tank = tankOf(rolling + baffle + "fillDepth 0.2;");
    EXPECT_NEAR(tank.distanceToWall(Vec(0, -0.4, 0.3)), 0.06, 1e-15);
    EXPECT_NEAR(tank.distanceToWall(Vec(7, 0, 0.15)), 0.05, 1e-15) << "the empty direction does not count";
    EXPECT_NEAR(tank.distanceToWall(Vec(0, 0.08, 0.14)), 0.05, 1e-15) << "from the baffle's edge";
    EXPECT_LT(tank.distanceToWall(Vec(0, 0, 0.05)), 0);
    EXPECT_LT(tank.distanceToWall(Vec(0, 0.5, 0.3)), 0);
    EXPECT_NEAR(tank.distanceToWall(Vec(0, 0.46, 0.3)), 0, 1e-15);
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
