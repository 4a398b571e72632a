// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/WallFriction.hpp"

#include "base/CaseError.hpp"
#include "dictionary/Dictionary.hpp"
#include "filling/fillTank.hpp"

#include <gtest/gtest.h>

namespace slosh
{
namespace
{

FluidProperties fluidOf(const std::string& text)
{
    return FluidProperties::read(Dictionary::parse("rho0 1000; viscosity { type none; walls slip; } " + text, "fluid"));
}

/// Liquid 0.1 m deep in a tank 0.4 m long that passes its bottom, and its bottom alone, at U.
struct OverTheBottom
{
    Tank tank = Tank::read(Dictionary::parse(
        "type box; plane xz; min (0 -0.5 0); max (0.4 0.5 0.3); fillDepth 0.1;", "constant/tankProperties"
    ));
    Filling filling = fillTank(tank, 0.01, 4, 1000, TaitEquation{1000, 10, 7}, 9.81, 3.69);
    std::vector<Vec> walls;
    std::vector<WallContact> contact;

    explicit OverTheBottom(const Vec& U)
    {
        Particles& particles = filling.particles;
        particles.remember(WallFriction::layerFields());
        walls.assign(particles.r.begin() + particles.nFluid, particles.r.end());
        for (const Vec& X : walls)
        {
            contact.push_back({X.z() < 0 && X.x() > 0 && X.x() < 0.4 ? 0.25 : 0, U});
        }
    }
    Vec sum(const std::vector<Vec>& accelerations) const
    {
        Vec force = Vec::Zero();
        for (const Vec& a : accelerations)
        {
            force += filling.particles.mass * a;
        }
        return force;
    }
};

TEST(WallFriction, TakesTheShearStressTimesTheWettedLength)
{
    const double U = 0.1, t = 0.02;
    OverTheBottom scene(Vec(U, 0, 0.3)); // what goes into the wall is no friction
    Particles& particles = scene.filling.particles;
    const SolverFrame frame(Frame::tank, RigidState());
    WallFriction friction(fluidOf("friction { type boundaryLayer; nu 1e-6; }"), scene.tank, 0, scene.walls, particles);
    friction.findNear(particles, frame, 0);
    friction.advance(particles, scene.contact, frame, 0); // wetted now
    friction.advance(particles, scene.contact, frame, t);
    std::vector<Vec> a(particles.nFluid, Vec::Zero());
    friction.addTo(particles, frame, a);
    // Per metre of breadth; the two particles in the corners may count for the side walls.
    const double expected = -1000 * U * std::sqrt(1e-6 / (std::numbers::pi * t)) * 0.4;
    EXPECT_NEAR(scene.sum(a).x() / expected, 0.97, 0.045);
    EXPECT_EQ(scene.sum(a).z(), 0);

    // A restart continues with the stored boundary layers; a wall that has dried has no layer.
    WallFriction again(fluidOf("friction { type boundaryLayer; nu 1e-6; }"), scene.tank, 0, scene.walls, particles);
    again.findNear(particles, frame, 0);
    std::vector<Vec> b(a.size(), Vec::Zero());
    again.addTo(particles, frame, b);
    EXPECT_EQ(a, b);
    const std::vector<WallContact> dry(scene.contact.size());
    again.advance(particles, dry, frame, t);
    b.assign(a.size(), Vec::Zero());
    again.addTo(particles, frame, b);
    EXPECT_EQ(scene.sum(b), Vec(Vec::Zero()));
}

TEST(WallFriction, IsTheSameInBothFrames)
{
    OverTheBottom scene(Vec(0.2, 0, 0));
    Particles& particles = scene.filling.particles;
    const FluidProperties fluid = fluidOf("friction { type boundaryLayer; nu 1e-6; }");
    std::vector<Vec> inTank(static_cast<std::size_t>(particles.nFluid), Vec::Zero()), inertial = inTank;
    for (auto& v : particles.v)
    {
        v = Vec(0.2, 0, 0);
    }
    std::fill(particles.v.begin() + particles.nFluid, particles.v.end(), Vec::Zero());
    const auto accelerations = [&](const SolverFrame& frame, std::vector<Vec>& a)
    {
        particles.remember({});
        particles.remember(WallFriction::layerFields());
        WallFriction friction(fluid, scene.tank, 0.3, scene.walls, particles);
        friction.findNear(particles, frame, 0);
        friction.advance(particles, scene.contact, frame, 1e-3);
        friction.addTo(particles, frame, a);
    };
    accelerations({Frame::tank, RigidState()}, inTank);

    RigidState tank; // 30 degrees about y, moving and turning
    tank.R = Eigen::AngleAxisd(0.5, Vec::UnitY()).toRotationMatrix();
    tank.c = Vec(1, 0, 2);
    tank.velocity = Vec(0.4, 0, -0.1);
    tank.omega = Vec(0, 2, 0);
    for (std::size_t i = 0; i < particles.r.size(); ++i)
    {
        const Vec X = particles.r[i];
        particles.r[i] = tank.pointToInertial(X);
        particles.v[i] = tank.velocityAt(X) + tank.R * particles.v[i];
    }
    for (std::size_t w = 0; w < scene.walls.size(); ++w)
    {
        const Vec away(0.001, 0, 0.007); // the liquid is seen there
        scene.contact[w].away = tank.R * away;
        scene.contact[w].velocity = tank.velocityAt(scene.walls[w] + away) + tank.R * scene.contact[w].velocity;
    }
    accelerations({Frame::inertial, tank}, inertial);
    for (std::size_t i = 0; i < inTank.size(); ++i)
    {
        EXPECT_LT((tank.R * inTank[i] - inertial[i]).norm(), 1e-12);
    }
    EXPECT_LT(scene.sum(inTank).x(), 0);
}

TEST(WallFriction, OfSideWallsIsThatOfStokesLayers)
{
    // SPHERIC test case 10: 62 mm between the walls, water, T = 1.6365 s: k = 0.042/s.
    const Tank tank = Tank::read(
        Dictionary::parse("type box; plane yz; min (-0.031 -0.45 0); max (0.031 0.45 0.508); fillDepth 0.093;", "tank")
    );
    const Vec g(0, 0, -9.81);
    EXPECT_NEAR(
        fluidOf("friction { type boundaryLayer; nu 8.96e-7; sideWalls { breadth 0.062; omega 3.8394; } }")
            .sideWallDrag(tank, g),
        0.0423, 1e-4
    );
    // omega auto: sqrt(g k tanh(k D)), k = pi/L
    EXPECT_NEAR(
        fluidOf("friction { type boundaryLayer; nu 8.96e-7; sideWalls { breadth 0.062; } }").sideWallDrag(tank, g),
        2 * std::sqrt(8.96e-7 * 3.2775 / 2) / 0.062, 1e-4
    );
    EXPECT_EQ(fluidOf("friction { type boundaryLayer; nu 8.96e-7; }").sideWallDrag(tank, g), 0);
    const Tank in3D =
        Tank::read(Dictionary::parse("type box; min (-0.031 -0.45 0); max (0.031 0.45 0.508); fillDepth 0.093;", "tank")
        );
    EXPECT_THROW(
        fluidOf("friction { type boundaryLayer; nu 1e-6; sideWalls { breadth 0.1; } }").sideWallDrag(in3D, g), CaseError
    );
    for (const std::string omega : {"0", "-4"})
    {
        EXPECT_THROW(
            fluidOf("friction { type boundaryLayer; nu 1e-6; sideWalls { breadth 0.1; omega " + omega + "; } }"),
            CaseError
        );
    }
}

TEST(WallFriction, IsRefusedWhereATimeHasSomeOfItsFieldsAlone)
{
    Particles particles;
    particles.resize(2, 3);
    EXPECT_NO_THROW(WallFriction::requireAllOrNoLayerFields(particles));
    particles.remember(WallFriction::layerFields());
    EXPECT_NO_THROW(WallFriction::requireAllOrNoLayerFields(particles));
    const std::string missing = particles.more.back().name;
    particles.more.pop_back();
    try
    {
        WallFriction::requireAllOrNoLayerFields(particles);
        FAIL();
    }
    catch (const CaseError& error)
    {
        EXPECT_NE(std::string(error.what()).find(missing), std::string::npos) << error.what();
    }
}

TEST(WallFriction, IsRefusedWhereLiquidSticks)
{
    EXPECT_THROW(
        FluidProperties::read(Dictionary::parse(
            "rho0 1000; viscosity { type artificial; alpha 0.01; walls "
            "noSlip; } friction { type boundaryLayer; nu 1e-6; }",
            "fluid"
        )),
        CaseError
    );
    EXPECT_THROW(fluidOf("friction { type boundaryLayer; }"), CaseError);
    EXPECT_THROW(fluidOf("friction { type boundaryLayer; nu -1e-6; }"), CaseError);
    EXPECT_THROW(fluidOf("friction { type boundarylayer; nu 1e-6; }"), CaseError);
    EXPECT_FALSE(fluidOf("friction { type none; }").friction.boundaryLayers);
}

} // namespace
} // namespace slosh
