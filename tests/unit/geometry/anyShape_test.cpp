// SPDX-License-Identifier: GPL-3.0-or-later
// What every shape has by its distance and bounds alone, and tanks and bodies of shapes that are no box.
#include "geometry/Tank.hpp"

#include "base/CaseError.hpp"
#include "dictionary/Dictionary.hpp"
#include "geometry/Box.hpp"
#include "geometry/Prism.hpp"
#include "geometry/Sphere.hpp"
#include "geometry/areaOfDisc.hpp"
#include "geometry/shapeTypes.hpp"
#include "geometry/volumeByQuadrature.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace slosh
{
namespace
{

constexpr double pi = std::numbers::pi;
const std::vector<int> xz = {0, 2}, xyz = {0, 1, 2};

/// A shape that says no more than it must: all within `radius` of the line between two points.
class Capsule final : public Shape
{
public:
    Capsule(const Vec& from, const Vec& to, double radius, std::vector<int> directions)
        : Shape("capsule", std::move(directions)), from_(from), to_(to), radius_(radius)
    {
    }
    NearestSurface nearestSurface(const Vec& X) const override
    {
        const double t = std::clamp((X - from_).dot(to_ - from_) / (to_ - from_).squaredNorm(), 0.0, 1.0);
        Vec away = X - from_ - t * (to_ - from_);
        for (int d = 0; d < 3; ++d)
        {
            away[d] = std::find(directions().begin(), directions().end(), d) == directions().end() ? 0 : away[d];
        }
        return {away.norm() - radius_, away.normalized()};
    }
    BoundingBox bounds() const override
    {
        const Vec r = Vec::Constant(radius_);
        return BoundingBox(from_.cwiseMin(to_) - r, from_.cwiseMax(to_) + r);
    }

private:
    Vec from_, to_;
    double radius_;
};

/// In the xz plane, 1 m thick: a rectangle of 2 x 1 m between two half discs.
std::shared_ptr<const Shape> lyingCapsule()
{
    return std::make_shared<Capsule>(Vec(-1, 0, 0.5), Vec(1, 0, 0.5), 0.5, xz);
}

Tank tankOf(const std::shared_ptr<const Shape>& walls, const std::string& fill)
{
    return {walls, {}, Fill::read(Dictionary::parse(fill, "constant/tankProperties"), *walls, {})};
}

TEST(AnyShape, HasItsVolumeByQuadrature)
{
    const Capsule slice({-1, 0, 0.5}, {1, 0, 0.5}, 0.5, xz);
    const double area = 2 + pi / 4;
    EXPECT_NEAR(slice.volumeInside(slice.bounds()), area, 1e-5 * area);
    BoundingBox half = slice.bounds();
    half.max().z() = 0.5;
    EXPECT_NEAR(slice.volumeInside(half), area / 2, 1e-5 * area);
    half.max().z() = 0.37; // between cells
    EXPECT_NEAR(slice.volumeInside(half), 2 * 0.37 + areaOfDisc(0.5, {-1, -0.5}, {1, -0.13}), 1e-5 * area);
    const Capsule whole({0, 0, 0}, {0.3, 0.4, 1.2}, 0.4, xyz); // 1.3 long, askew
    const double volume = pi * 0.16 * 1.3 + 4.0 / 3 * pi * 0.064;
    EXPECT_NEAR(whole.volumeInside(whole.bounds()), volume, 5e-5 * volume);
    // Where no surface passes nothing is lost.
    EXPECT_NEAR(slice.volumeInside(BoundingBox(Vec(-0.7, -9, 0.1), Vec(0.9, 9, 0.8))), 1.6 * 0.7, 1e-14);
    EXPECT_EQ(slice.volumeInside(BoundingBox(Vec(2, -9, 0), Vec(3, 9, 1))), 0);
}

TEST(AnyShape, HasTheChordsThatItsDistanceHas)
{
    const auto shape = lyingCapsule();
    const auto across = shape->chords(0, {7, 0, 0.8});
    ASSERT_EQ(across.size(), 1u);
    EXPECT_NEAR(across[0].first, -1.4, 1e-14);
    EXPECT_NEAR(across[0].second, 1.4, 1e-14);
    const auto up = shape->chords(2, {1.3, 0, 0});
    ASSERT_EQ(up.size(), 1u);
    EXPECT_NEAR(up[0].first, 0.1, 1e-14);
    EXPECT_NEAR(up[0].second, 0.9, 1e-14);
    EXPECT_TRUE(shape->chords(2, {1.6, 0, 0}).empty());
    // Those of a prism, found by sampling, are those of its polygon.
    const Prism u({Polygon({{0, 0}, {5, 0}, {5, 3}, {4, 3}, {4, 1}, {1, 1}, {1, 3}, {0, 3}}), {0, 2}}, -1, 1, true);
    const auto sampled = u.Shape::chords(0, {0, 0, 2.5}), exact = u.chords(0, {0, 0, 2.5});
    ASSERT_EQ(sampled.size(), 2u);
    ASSERT_EQ(exact.size(), 2u);
    for (int k = 0; k < 2; ++k)
    {
        EXPECT_NEAR(sampled[k].first, exact[k].first, 1e-14);
        EXPECT_NEAR(sampled[k].second, exact[k].second, 1e-14);
    }
}

TEST(AnyShape, MakesATank)
{
    const Tank tank = tankOf(lyingCapsule(), "fillDepth 0.5;");
    EXPECT_EQ(tank.dim(), 2);
    EXPECT_EQ(tank.emptyDirection(), 1);
    EXPECT_EQ(tank.thickness(), 1);
    EXPECT_FALSE(tank.isBox());
    EXPECT_NEAR(tank.fill().volume(), 1 + pi / 8, 2e-5);
    EXPECT_TRUE(tank.isInside({1.3, 99, 0.15}));
    EXPECT_FALSE(tank.isInside({1.45, 0, 0.15}));
    EXPECT_NEAR(tank.distanceToWall({1.3, 0, 0.9}), 0, 1e-14);
    EXPECT_NEAR(tank.distanceToWall({1.6, 0, 0.5}), -0.1, 1e-14);
    EXPECT_NEAR(tank.nearestWall({1.4, 0, 0.5}).normal.x(), -1, 1e-14);
    EXPECT_NEAR(tank.verticalExtent({1.3, 0, 0.5}).second, 0.9, 1e-14);
    const double k = pi / 3;
    EXPECT_NEAR(tank.naturalFrequencies(9.81, 1).front(), std::sqrt(9.81 * k * std::tanh(k / 2)), 1e-7);
    EXPECT_FALSE(tank.liquidIsBox());
    EXPECT_EQ(tank.walls().outline().edges.size(), 4u);
    EXPECT_EQ(tank.walls().description(), "a capsule");
    const Tank byVolume = tankOf(lyingCapsule(), "fillVolume 1.39269908169872;"); // 1 + pi/8
    EXPECT_NEAR(byVolume.fill().level(), 0.5, 1e-5);
    EXPECT_THROW(tankOf(lyingCapsule(), "fillDepth 1.1;"), CaseError);
}

TEST(Shapes, DrawTheEdgesOfThreeDimensionsAndOfASlice)
{
    const BoundingBox box(Vec(0, 0, 0), Vec(1, 2, 3));
    EXPECT_EQ(Box("box", box, xyz).outline().edges.size(), 12u);
    EXPECT_EQ(Box("box", box, xz).outline().corners.front(), Vec(0, 1, 0));
    const DrawnSection triangle{Polygon({{0, 0}, {1, 0}, {0, 1}}), {1, 2}};
    EXPECT_EQ(Prism(triangle, 0, 4, false).outline().edges.size(), 9u);
    EXPECT_EQ(Prism(triangle, 0, 4, true).outline().corners.back(), Vec(2, 0, 1));
}

/// By 400 x 400 points.
double areaBySampling(double R, const Vec2& low, const Vec2& high)
{
    constexpr int n = 400;
    int inside = 0;
    for (int i = 0; i < n * n; ++i)
    {
        const Vec2 x = low + Vec2((i % n + 0.5) / n, (i / n + 0.5) / n).cwiseProduct(high - low);
        inside += x.norm() < R ? 1 : 0;
    }
    return (high - low).prod() * inside / (n * n);
}

TEST(AreaOfDisc, IsThatOfThePartInARectangle)
{
    EXPECT_NEAR(areaOfDisc(2, {-5, -5}, {5, 5}), 4 * pi, 1e-14);
    EXPECT_NEAR(areaOfDisc(2, {-5, -5}, {5, 0}), 2 * pi, 1e-14);
    EXPECT_NEAR(areaOfDisc(2, {0, 0}, {9, 9}), pi, 1e-14);
    EXPECT_NEAR(areaOfDisc(2, {-1, -1}, {1, 1}), 4, 1e-14);
    // Segment above a height of half the radius.
    EXPECT_NEAR(areaOfDisc(1, {-1, 0.5}, {1, 1}), pi / 3 - std::sqrt(3) / 4, 1e-14);
    EXPECT_EQ(areaOfDisc(1, {1, 1}, {2, 2}), 0);
    EXPECT_EQ(areaOfDisc(1, {-9, 3}, {9, 4}), 0);
    for (const auto& [low, high] :
         {std::pair{Vec2(-0.9, -0.2), Vec2(0.1, 0.8)},
          {Vec2(0.3, -2), Vec2(0.8, 0.4)},
          {Vec2(0.5, 0.5), Vec2(2, 2)},
          {Vec2(-2, 0.6), Vec2(0.7, 0.9)}})
    {
        EXPECT_NEAR(areaOfDisc(1, low, high), areaBySampling(1, low, high), 2e-3) << low.transpose();
    }
}

TEST(Sphere, HasTheVolumeOfItsParts)
{
    const BoundingBox around(Vec(-1, -1, -1), Vec(1, 1, 1));
    const Sphere sphere("ball", Vec::Zero(), 1, around, xyz);
    EXPECT_NEAR(sphere.volumeInside(BoundingBox(Vec(-2, -2, -2), Vec(2, 2, -0.5))), pi / 4 * (3 - 0.5) / 3, 1e-14);
    EXPECT_NEAR(sphere.volumeInside(BoundingBox(Vec(-2, -2, 0), Vec(2, 2, 2))), 2 * pi / 3, 1e-14);
    EXPECT_NEAR(sphere.volumeInside(BoundingBox(Vec(0, 0, 0), Vec(2, 2, 2))), pi / 6, 5e-5 * pi / 6);
    EXPECT_EQ(sphere.volumeInside(BoundingBox(Vec(1, 1, 1), Vec(2, 2, 2))), 0);
    EXPECT_NEAR(sphere.Shape::volumeInside(around), 4 * pi / 3, 5e-5 * 4 * pi / 3) << "by quadrature";
}

const std::string cube = "type box; min (0 0 0); max (1 1 1); ";

Tank read(const std::string& text)
{
    return Tank::read(Dictionary::parse(text, "constant/tankProperties"));
}

TEST(Bodies, AreOfAnyShapeAndLiquidGoesAroundThem)
{
    const std::string ball = "geometry { ball { type searchableSphere; centre (0.5 0.5 0.3); radius 0.2; } } ";
    EXPECT_NEAR(read(cube + ball + "fillDepth 0.6;").fill().volume(), 0.6 - 4.0 / 3 * pi * 0.008, 1e-14);
    EXPECT_NEAR(read(cube + ball + "fillDepth 0.3;").fill().volume(), 0.3 - 2.0 / 3 * pi * 0.008, 1e-14);
    const Tank byVolume = read(cube + ball + "fillVolume #eval \"0.3 - 0.016*pi()/3\";"); // to the ball's middle
    EXPECT_NEAR(byVolume.fill().level(), 0.3, 1e-12);
    EXPECT_FALSE(byVolume.isInside({0.5, 0.6, 0.3}));
    EXPECT_TRUE(byVolume.isInside({0.65, 0.65, 0.45}));
    EXPECT_NEAR(byVolume.distanceToWall({0.5, 0.5, 0.55}), 0.05, 1e-14);
    EXPECT_NEAR(byVolume.nearestWall({0.5, 0.5, 0.55}).normal.z(), 1, 1e-14);
    // What sticks out of the tank is not in the liquid.
    const Tank quarter = read(
        "plane xz; " + cube + "geometry { bump { type searchableSphere; centre (0 9 0); radius 0.4; } } fillDepth 1;"
    );
    EXPECT_NEAR(quarter.fill().volume(), 1 - pi / 4 * 0.16, 1e-14);
    // In a prism: of a disc in the corner of a triangle half the angle, 45 of 360 degrees.
    const Tank corner =
        read("type prism; plane xz; section xz; extent (0 1); polygon ((0 0) (1 0) (1 1)); fillDepth 1; "
             "geometry { bump { type searchableSphere; centre (0 9 0); radius 0.4; } }");
    EXPECT_NEAR(corner.fill().volume(), 0.5 - pi / 8 * 0.16, 1e-6);
    EXPECT_THROW(
        read("type prism; plane xz; section xz; extent (0 1); polygon ((0 0) (1 0) (1 1)); fillDepth 1; "
             "geometry { out { type searchableSphere; centre (0.2 9 0.8); radius 0.1; } }"),
        CaseError
    );
    EXPECT_THROW(
        read(
            cube + "geometry { a { type searchableSphere; centre (0.5 0.5 0.3); radius 0.2; } b { type "
                   "searchableBox; min (0.4 0.4 0.4); max (0.6 0.6 0.6); } } fillDepth 1;"
        ),
        CaseError
    );
}

TEST(ShapeTypes, AreTheOnesThatErrorsName)
{
    const auto messageOf = [](const std::string& text)
    {
        try
        {
            read(text);
        }
        catch (const CaseError& error)
        {
            return std::string(error.what());
        }
        return std::string("accepted");
    };
    const auto expectAll = [](const std::vector<ShapeType>& types, const std::string& text, const std::string& between)
    {
        std::string names;
        for (const ShapeType& type : types)
        {
            names += (names.empty() ? "" : between) + std::string(type.name);
            EXPECT_FALSE(type.sentence.empty()) << type.name;
        }
        EXPECT_NE(text.find(names), std::string::npos) << names << " is not in: " << text;
    };
    expectAll(wallTypes(), messageOf("type can; fillDepth 1;"), " ");
    expectAll(bodyTypes(), messageOf(cube + "fillDepth 1; geometry { b { type searchableBlob; } }"), " ");
    expectAll(bodyTypes(), messageOf(cube + "liquid { b { type searchableBlob; } }"), " ");
}

/// The entries of a type as the annotated dictionary has them.
std::string examplesOf(const ShapeType& type)
{
    std::string text = "type " + std::string(type.name) + ";";
    for (const Key& key : type.entries())
    {
        text += " " + std::string(key.name) + " " + std::string(key.example) + ";";
    }
    return text;
}

TEST(ShapeTypes, HaveExamplesThatMakeATank)
{
    for (const ShapeType& type : wallTypes())
    {
        EXPECT_NO_THROW(read("plane yz; fillDepth 0.155; " + examplesOf(type))) << type.name;
    }
    for (const ShapeType& type : bodyTypes())
    {
        const Tank tank =
            read(examplesOf(wallTypes().front()) + " fillDepth 0.155; geometry { body { " + examplesOf(type) + " } }");
        EXPECT_EQ(tank.partNames().back(), "body");
    }
    for (const Key& fill : fillKeys())
    {
        std::string text = std::string(fill.name) + " " + std::string(fill.example) + ";";
        if (fill.entries != nullptr)
        {
            text = std::string(fill.name) + " {";
            for (const Key& region : fill.entries())
            {
                text += std::string(region.name) + " {" + std::string(region.example) + "} ";
            }
            text += "}";
        }
        EXPECT_NO_THROW(read(examplesOf(wallTypes().front()) + text)) << text;
    }
}

} // namespace
} // namespace slosh
