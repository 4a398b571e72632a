// SPDX-License-Identifier: GPL-3.0-or-later
// Sensors with a face: where its points are, and its mean in still water, where the answer is a centroid's depth.
#include "sampling/sensorFace.hpp"

#include "StillWater.hpp"

#include "sampling/samplePoint.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <unistd.h>

namespace slosh
{
namespace
{

using std::numbers::pi;
using Shape = FaceForm::Shape;

constexpr double dx = 0.02;

Tank tankOf(const std::string& entries)
{
    return Tank::read(Dictionary::parse(entries, "constant/tankProperties"));
}

/// Where the face's mean of X lies, and the part of the sum that is there.
Vec centroidOf(const SensorFace& face)
{
    Vec sum = Vec::Zero();
    double shares = 0;
    for (const SensorFace::Point& point : face.points())
    {
        sum += point.share * point.X;
        shares += point.share;
    }
    EXPECT_NEAR(shares, 1, 1e-12);
    return sum;
}

/// Of the part of a disc of radius R that is above the chord at the height c over its middle: the area and the moment
/// int t dA about the middle.
struct DiscAbove
{
    double area, moment;
    DiscAbove(double R, double c)
        : area(R * R * std::acos(c / R) - c * std::sqrt(R * R - c * c)), moment(2.0 / 3 * std::pow(R * R - c * c, 1.5))
    {
    }
};

TEST(SensorFace, LiesInItsWallAndHasItsMiddleAtTheProbe)
{
    const double r = std::sqrt(0.5);
    const std::string prism = "type prism; section yz; polygon ((0 0.2) (0.2 0) (1 0) (1 1) (0 1)); extent (0 1); "
                              "fillLevel 0.5; ";
    struct Place
    {
        std::string tank;
        Vec X, normal;
    };
    for (const Place& place :
         {Place{"type box; min (0 0 0); max (1 1 1); fillLevel 0.5;", Vec(0, 0.4, 0.3), Vec(1, 0, 0)},
          {"type box; min (0 0 0); max (1 1 1); fillLevel 0.5;", Vec(0.5, 0.4, 1), Vec(0, 0, -1)},
          {"type box; min (0 0 0); max (1 1 1); fillLevel 0.5;", Vec(0.5, 0.4, 0.3 * dx), Vec(0, 0, 1)},
          {prism, Vec(0.5, 0.1, 0.1), Vec(0, r, r)},
          {"plane yz; " + prism, Vec(0.5, 0.1, 0.1), Vec(0, r, r)},
          {"type box; min (0 0 0); max (1 1 1); fillLevel 0.5; geometry { b { type searchableBox; min (0.4 0 0); max "
           "(0.6 1 0.4); } }",
           Vec(0.4, 0.5, 0.2), Vec(-1, 0, 0)}})
    {
        const Tank tank = tankOf(place.tank);
        for (const Shape shape : {Shape::disc, Shape::square})
        {
            const SensorFace face(tank, place.X, {shape, 0.1}, dx);
            EXPECT_NEAR((centroidOf(face) - place.X).norm(), 0, 1e-9) << place.tank;
            Vec spread = Vec::Zero();
            for (const SensorFace::Point& point : face.points())
            {
                EXPECT_NEAR((point.X - place.X).dot(place.normal), 0, 1e-9) << place.tank;
                spread += point.share * (point.X - place.X).cwiseAbs2();
            }
            // The second moment of the cells' centroids lacks that of the cells themselves.
            const double cell = 0.1 / 10;
            const double exact = shape == Shape::disc ? 0.1 * 0.1 / 16 : 0.1 * 0.1 / 12;
            EXPECT_NEAR(spread.sum() / (tank.dim() - 1), exact - cell * cell / 12, 0.02 * exact)
                << place.tank << "\n2D and 3D have the same moment: the chord weighs the segment";
        }
    }
}

TEST(SensorFace, HasPointsNoFartherApartThanHalfASpacingAndEightAcross)
{
    const Tank tank = tankOf("type box; plane xz; min (0 0 0); max (1 1 1); fillLevel 0.5;");
    const Vec X(0, 0.5, 0.3);
    EXPECT_EQ(SensorFace(tank, X, {Shape::square, 0.5 * dx}, dx).points().size(), 8u);
    EXPECT_EQ(SensorFace(tank, X, {Shape::square, 5.2 * dx}, dx).points().size(), 11u);
}

TEST(SensorFace, LeavesOutWhatIsBeyondACornerOrTheEdgeOfABody)
{
    const double R = 0.05, c = 0.02;
    const DiscAbove disc(R, -c);
    for (const std::string plane : {"", "plane xz; "})
    {
        const Tank box = tankOf(
            plane + "type box; min (0 0 0); max (1 1 1); fillLevel 0.5; geometry { b { type "
                    "searchableBox; min (0.4 0 0); max (0.6 1 0.4); } }"
        );
        const SensorFace atFloor(box, Vec(0, 0.5, c), {Shape::disc, 2 * R}, dx);
        EXPECT_NEAR(centroidOf(atFloor).z(), c + disc.moment / disc.area, 1e-3 * R) << plane;
        const SensorFace atEdge(box, Vec(0.4, 0.5, 0.4 - c), {Shape::disc, 2 * R}, dx);
        EXPECT_NEAR(centroidOf(atEdge).z(), 0.4 - c - disc.moment / disc.area, 1e-3 * R) << plane;
        const SensorFace onTop(box, Vec(0.4 + c, 0.5, 0.4), {Shape::square, 2 * R}, dx);
        EXPECT_NEAR(centroidOf(onTop).x(), 0.4 + (c + R) / 2, 1e-3 * R) << plane;
    }
    const Tank box = tankOf("type box; min (0 0 0); max (1 1 1); fillLevel 0.5;");
    const SensorFace inCorner(box, Vec(0, 0.01, 0.02), {Shape::square, 0.1}, dx);
    EXPECT_NEAR((centroidOf(inCorner) - Vec(0, 0.03, 0.035)).norm(), 0, 1e-4);
}

TEST(SensorFace, ReadsTheDepthOfTheCentroidOfAFaceThatACornerCuts)
{
    const double R = 0.05, c = 0.015;
    const DiscAbove disc(R, -c);
    for (const int dim : {2, 3})
    {
        const StillWater water(dim);
        const SensorFace face(water.scene.tank, Vec(0, 0.1, c), {Shape::disc, 2 * R}, water.dx);
        const double z = c + disc.moment / disc.area;
        EXPECT_NEAR(face.pressure(water.snapshot()), rho0 * g * (D - z), 3e-4 * rho0 * g * D) << dim << "D";
        const SensorFace square(water.scene.tank, Vec(0.3, 0.1, 0), {Shape::square, 0.08}, water.dx);
        EXPECT_NEAR(square.pressure(water.snapshot()), rho0 * g * D, 3e-4 * rho0 * g * D) << dim << "D, floor";
    }
}

TEST(SensorFace, CountsWhatIsAboveTheSurfaceAsZero)
{
    const double R = 0.06;
    for (const int dim : {2, 3})
    {
        const StillWater water(dim);
        for (const double above : {-0.03, 0.0, 0.013, 0.04})
        {
            // Below the surface lie A' and, from there down, the moment of the depth M - above A'.
            const DiscAbove wet(R, above);
            const double mean = rho0 * g * (wet.moment - above * wet.area) / (pi * R * R);
            const SensorFace face(water.scene.tank, Vec(0, 0.1, D + above), {Shape::disc, 2 * R}, water.dx);
            EXPECT_NEAR(face.pressure(water.snapshot()), mean, 0.01 * rho0 * g * R) << dim << "D, " << above;
        }
    }
}

TEST(SensorFace, OfNoSizeReadsWhatTheProbeReads)
{
    for (const int dim : {2, 3})
    {
        const StillWater water(dim);
        const Snapshot snapshot = water.snapshot();
        for (const Vec& X : {Vec(0, 0.1, 0.15), Vec(0.3 * dx, 0.1, 0.0731), Vec(0, 0.1, 0), Vec(0, 0.1, 0.5)})
        {
            const double p = pressureAt(snapshot, X);
            EXPECT_EQ(SensorFace(X).pressure(snapshot), p);
            for (const Shape shape : {Shape::disc, Shape::square})
            {
                EXPECT_NEAR(
                    SensorFace(water.scene.tank, X, {shape, 1e-8}, dx).pressure(snapshot), p, 1e-6 * rho0 * g * D
                );
            }
        }
    }
}

/// What probes say of these entries; "" where it is content.
std::string answerTo(const std::string& entries)
{
    const StillWater water(3);
    const auto folder = std::filesystem::temp_directory_path() / ("slosh.face." + std::to_string(::getpid()));
    const Dictionary dict = Dictionary::parse("fields (p); " + entries, "system/probesDict");
    try
    {
        choiceNamed(FunctionObject::choices(), "probes").read({dict, water.scene, folder, 6});
    }
    catch (const CaseError& error)
    {
        return error.what();
    }
    return "";
}

TEST(SensorFace, IsRefusedWhereItMeansNothing)
{
    const std::string atWall = "probeLocations ((0 0.1 0.15)); ", inLiquid = "probeLocations ((0.3 0.1 0.15)); ";
    EXPECT_EQ(answerTo(atWall + "radius 0.01;"), "");
    EXPECT_EQ(answerTo(atWall + "size 0.01;"), "");
    EXPECT_EQ(answerTo(inLiquid), "") << "a probe without a face may be anywhere";
    EXPECT_EQ(answerTo("probeLocations ((0.0099 0.1 0.15)); radius 0.01;"), "");
    for (const auto& [entries, fragment] : std::vector<std::pair<std::string, std::string>>{
             {atWall + "radius 0.01; size 0.01;", "size and radius are both set"},
             {atWall + "radius -1;", "radius is -1"},
             {atWall + "size 0;", "size is 0"},
             {inLiquid + "radius 0.01;", "(0.3 0.1 0.15) is 0.1 m from the nearest one, farther than half a particle "
                                         "spacing of 0.02 m"},
             {"probeLocations ((0.0101 0.1 0.15)); size 0.01;", "size gives probes a face, which must lie on a wall"}})
    {
        const std::string answer = answerTo(entries);
        EXPECT_NE(answer.find(fragment), std::string::npos) << entries << "\n" << answer;
        EXPECT_NE(answer.find("system/probesDict:1: "), std::string::npos) << answer;
    }
}

} // namespace
} // namespace slosh
