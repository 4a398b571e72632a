// SPDX-License-Identifier: GPL-3.0-or-later
#include "filling/fillTank.hpp"
#include "filling/wallLayers.hpp"

#include "dictionary/Dictionary.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <sstream>

namespace slosh
{
namespace
{

constexpr TaitEquation tait{1000, 20, 7};
constexpr int layers = 4;

/// A full section in spacings of 1, without gravity, its particles in the plane.
struct Filled
{
    std::vector<Vec2> liquid, wall;
    Polygon polygon;
    double volume = 1; ///< of a particle
    double cell = 1;   ///< of the lattice
    double dx() const { return std::sqrt(cell); }

    explicit Filled(const std::vector<Vec2>& corners) : polygon(corners)
    {
        std::ostringstream text;
        text.precision(17);
        text << "type prism; plane yz; section yz; extent (-1 1); fillLevel " << polygon.high().y() << "; polygon (";
        for (const Vec2& x : corners)
        {
            text << "(" << x.x() << " " << x.y() << ") ";
        }
        const Tank tank = Tank::read(Dictionary::parse(text.str() + ");", "constant/tankProperties"));
        const Filling filling = fillTank(tank, 1, layers, 1000, tait, 0, 3.69);
        const Particles& particles = filling.particles;
        for (std::ptrdiff_t i = 0; i < particles.nFluid + particles.nWall; ++i)
        {
            const Vec& r = particles.r[i];
            (i < particles.nFluid ? liquid : wall).emplace_back(r.y(), r.z());
        }
        volume = particles.mass / 1000;
        cell = filling.spacing.y() * filling.spacing.z();
    }

    /// sum_b V W(x - x_b) over these, the Gaussian of smoothing length 1.23, whose integral is 1.
    double sum(const std::vector<Vec2>& points, const Vec2& x) const
    {
        const double h2 = 1.23 * 1.23;
        double sum = 0;
        for (const Vec2& y : points)
        {
            sum += std::exp(-(x - y).squaredNorm() / h2);
        }
        return volume * sum / (std::numbers::pi * h2);
    }
};

double least(const std::vector<Vec2>& a, const Vec2& x)
{
    double least = 1e300;
    for (const Vec2& y : a)
    {
        least = std::min(least, (x - y).norm());
    }
    return least;
}

std::vector<Vec2> wedge(double degrees)
{
    const double tangent = std::tan(degrees * std::numbers::pi / 360);
    return {{0, 0}, {30 * tangent, 30}, {-30 * tangent, 30}};
}

struct Kind
{
    std::string name;
    std::vector<Vec2> corners;
    double most;    ///< that the sum of W is off 1 anywhere in the liquid
    double nearest; ///< two wall particles
};

void PrintTo(const Kind& kind, std::ostream* out)
{
    *out << kind.name;
}

std::vector<Kind> kinds()
{
    std::vector<Vec2> circle;
    for (int i = 0; i < 48; ++i)
    {
        circle.emplace_back(15 * std::cos(i * std::numbers::pi / 24), 15 * std::sin(i * std::numbers::pi / 24));
    }
    return {
        {"convex45", {{0, 8}, {8, 0}, {32, 0}, {40, 8}, {40, 24}, {30, 34}, {10, 34}, {0, 24}}, 0.006, 0.95},
        {"oddAngles", {{0, 0}, {30, 0}, {41.3, 22.1}, {2.1, 20}}, 0.013, 0.95},
        {"reflex90", {{0, 0}, {40, 0}, {40, 12}, {21.3, 12}, {21.3, 30}, {0, 30}}, 0.01, 0.95},
        {"reflex45", {{0, 0}, {12, 0}, {17, 5}, {30, 5}, {30, 25}, {0, 25}}, 0.008, 0.95},
        {"acute60", wedge(60), 0.02, 0.95},
        {"acute30", wedge(30), 0.05, 0.5},
        {"reflex30", {{0, 0}, {12, 0}, {16.02, 15}, {20.04, 0}, {32, 0}, {32, 28}, {0, 28}}, 0.01, 0.5},
        {"round", circle, 0.01, 0.95},
    };
}

class SectionSites : public testing::TestWithParam<Kind>
{
};

/// One of them, a short one, and the others.
std::vector<Kind> someKinds(bool isShort)
{
    std::vector<Kind> kinds = slosh::kinds();
    kinds.erase(
        std::remove_if(
            kinds.begin(), kinds.end(), [&](const Kind& kind) { return (kind.name == "acute30") != isShort; }
        ),
        kinds.end()
    );
    return kinds;
}

std::string nameOf(const testing::TestParamInfo<Kind>& info)
{
    return info.param.name;
}

INSTANTIATE_TEST_SUITE_P(OfCorners, SectionSites, testing::ValuesIn(someKinds(true)), nameOf);
INSTANTIATE_TEST_SUITE_P(LongOfCorners, SectionSites, testing::ValuesIn(someKinds(false)), nameOf);

TEST_P(SectionSites, LeaveTheKernelsSumAsItIsFarFromWalls)
{
    const Filled filled(GetParam().corners);
    double most = 0;
    for (const Vec2& x : filled.liquid)
    {
        // Walls end four spacings deep: the rest of the Gaussian, beyond 3h, is 1e-4.
        most = std::max(most, std::abs(filled.sum(filled.liquid, x) + filled.sum(filled.wall, x) - 1));
    }
    RecordProperty("largest_deviation", std::to_string(most));
    EXPECT_LT(most, GetParam().most);
    EXPECT_NEAR(filled.volume / filled.cell, 1, 0.003); // as many cells as the area holds
}

TEST_P(SectionSites, LeaveNoHoleAndPutNoTwoParticlesIntoOnePlace)
{
    const Filled filled(GetParam().corners);
    std::vector<Vec2> all = filled.liquid;
    all.insert(all.end(), filled.wall.begin(), filled.wall.end());
    const Polygon& polygon = filled.polygon;
    // The middle of four on a lattice is 0.71 from them.
    double hole = 0;
    for (double y = polygon.low().x() - 3; y < polygon.high().x() + 3; y += 0.17)
    {
        for (double z = polygon.low().y() - 3; z < polygon.high().y() + 3; z += 0.17)
        {
            const double outside = polygon.nearest({y, z}).distance;
            hole = outside > 0 && outside < 3 ? std::max(hole, least(all, {y, z})) : hole;
        }
    }
    EXPECT_LT(hole, 0.85);
    double nearest = 1e300;
    for (std::size_t i = 0; i < filled.wall.size(); ++i)
    {
        EXPECT_GE(
            polygon.nearest(filled.wall[i]).distance,
            0.5 * filled.dx() - 1e-6
        ); // none in the liquid, nor at its edge
        EXPECT_LT(polygon.nearest(filled.wall[i]).distance, layers * filled.dx());
        for (std::size_t j = 0; j < i; ++j)
        {
            nearest = std::min(nearest, (filled.wall[i] - filled.wall[j]).norm());
        }
    }
    EXPECT_GT(nearest, GetParam().nearest);
    for (const Vec2& x : filled.liquid)
    {
        EXPECT_LT(polygon.nearest(x).distance, -0.25 * filled.dx() + 1e-6);
        EXPECT_GT(least(filled.wall, x), 0.7);
    }
}

TEST(WallLayers, OfARectangleOfWholeSpacingsAreTheLattice)
{
    const std::vector<Vec2> wall = wallLayers(Polygon({{0, 0}, {6, 0}, {6, 4}, {0, 4}}), 1, 3);
    std::size_t found = 0;
    for (int i = -3; i < 9; ++i)
    {
        for (int j = -3; j < 7; ++j)
        {
            const Vec2 x(i + 0.5, j + 0.5);
            const bool isLiquid = i >= 0 && i < 6 && j >= 0 && j < 4;
            // At the far end of the corners, 3.5 out, nothing feels a wall particle.
            const bool isFar = (std::abs(x.x() - 3) - 3 > 2 && std::abs(x.y() - 2) - 2 > 2);
            const bool isWall = least(wall, x) < 1e-12;
            EXPECT_EQ(
                isWall, !isLiquid && !isFar && Vec2((x - Vec2(3, 2)).cwiseAbs() - Vec2(3, 2)).cwiseMax(0).norm() < 3
            ) << x.transpose();
            found += isWall ? 1 : 0;
        }
    }
    EXPECT_EQ(found, wall.size());
}

TEST(LongWallLayers, AreTheSameAllAlongASideOfAnyDirection)
{
    // What a particle half a spacing off feels of the wall as it slides along: on a lattice rows at 1, 2 ... spacings.
    constexpr double h = 1.23;
    double onLattice = 0;
    for (int k = 1; k <= layers; ++k)
    {
        onLattice += std::exp(-k * k / (h * h)) / (h * std::sqrt(std::numbers::pi));
    }
    for (const double degrees : {0.0, 45.0, 27.0, 11.3})
    {
        const double a = degrees * std::numbers::pi / 180;
        const Vec2 along(std::cos(a), std::sin(a)), in(-along.y(), along.x());
        const Vec2 end = 40.2 * along;
        const Polygon polygon({Vec2(0, 0), end, end + 20 * in, 20 * in});
        const Filled filled({polygon.corners().begin(), polygon.corners().end()});
        double low = 1e300, high = 0;
        for (double s = 8; s < 32; s += 0.1)
        {
            const double wall = filled.sum(filled.wall, s * along + 0.5 * in);
            low = std::min(low, wall);
            high = std::max(high, wall);
        }
        EXPECT_LT(high / low, 1.002) << degrees;
        EXPECT_NEAR(high, onLattice, 0.02 * onLattice) << degrees;
    }
}

TEST(LongSectionSites, HaveTheExactMassWhateverTheLattice)
{
    for (const double dx : {0.05, 0.031, 0.0123})
    {
        const Tank tank = Tank::read(Dictionary::parse(
            "type prism; plane xz; section xz; extent (0 0.5); polygon ((0 "
            "0.2) (0.2 0) (1 0) (1 1) (0 1)); fillDepth 0.6;",
            "constant/tankProperties"
        ));
        const Particles particles = fillTank(tank, dx, 4, 998, tait, 9.81, 3.69).particles;
        const double mass = particles.mass * static_cast<double>(particles.nFluid) * tank.thickness();
        EXPECT_NEAR(mass, 998 * 0.5 * (0.6 - 0.02), 1e-9);
        for (std::ptrdiff_t i = 0; i < particles.nFluid; ++i)
        {
            EXPECT_EQ(particles.r[i].y(), 0.25);
        }
    }
}

TEST(SectionSites, StandInSectionsAlongAPrismThatItsEndsClose)
{
    const Tank tank = Tank::read(Dictionary::parse(
        "type prism; section yz; extent (0 10); polygon ((0 4) (4 0) (16 0) (16 12) (0 12)); fillDepth 6;",
        "constant/tankProperties"
    ));
    const Particles particles = fillTank(tank, 1, 4, 1000, tait, 0, 3.69).particles;
    std::map<long, std::pair<int, int>> perSection; // liquid and wall by x
    for (std::size_t i = 0; i < particles.r.size(); ++i)
    {
        auto& [liquid, wall] = perSection[std::lround(particles.r[i].x() - 0.5)];
        ++(static_cast<std::ptrdiff_t>(i) < particles.nFluid ? liquid : wall);
    }
    ASSERT_EQ(perSection.size(), 18u);
    const auto [inner, layersOfInner] = perSection.at(5);
    EXPECT_EQ(inner, 16 * 6 - 8);
    for (const auto& [x, count] : perSection)
    {
        const bool isEnd = x < 0 || x >= 10;
        EXPECT_EQ(count.first, isEnd ? 0 : inner) << x;
        EXPECT_EQ(count.second, isEnd ? layersOfInner + 16 * 12 - 8 : layersOfInner) << x;
    }
}

TEST(LongSectionSites, AreMirroredInAMirroredTank)
{
    const Filled filled({{0, 8}, {8, 0}, {32, 0}, {40, 8}, {40, 24}, {30, 34}, {10, 34}, {0, 24}});
    for (const Vec2& x : filled.liquid)
    {
        EXPECT_LT(least(filled.liquid, {40 - x.x(), x.y()}), 1e-6);
    }
}

} // namespace
} // namespace slosh
