// SPDX-License-Identifier: GPL-3.0-or-later
#include "filling/fillTank.hpp"

#include "dictionary/Dictionary.hpp"
#include "geometry/Sphere.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace slosh
{
namespace
{

constexpr TaitEquation tait{1000, 20, 7};
constexpr double pi = std::numbers::pi;

/// A lattice's cells around those of the liquid are wall, or liquid: how many are missing within the kernel's reach.
int missingAround(const Particles& particles, double dx, const std::vector<int>& directions, const Tank& tank)
{
    int missing = 0;
    for (std::ptrdiff_t i = 0; i < particles.nFluid; ++i)
    {
        for (const int d : directions)
        {
            for (const int side : {-1, 1})
            {
                const Vec X = particles.r[i] + side * dx * Vec::Unit(d);
                const bool isThere = std::any_of(
                    particles.r.begin(), particles.r.end(), [&](const Vec& r) { return (r - X).norm() < 1e-6 * dx; }
                );
                missing += isThere || X.z() > tank.fill().level() ? 0 : 1;
            }
        }
    }
    return missing;
}

TEST(LatticeSites, FillATankOfAShapeThatNoStrategyIsMadeFor)
{
    const BoundingBox bounds(Vec(-1, -1, -1), Vec(1, 1, 1));
    const auto walls = std::make_shared<Sphere>("sphere", Vec::Zero(), 1, bounds, std::vector{0, 1, 2});
    const Tank tank(walls, {}, Fill::read(Dictionary::parse("fillDepth 1;", "constant/tankProperties"), *walls, {}));
    const Filling filling = fillTank(tank, 0.1, 3, 1000, tait, 0, 3);
    const Particles& p = filling.particles;
    const double mass = p.mass * static_cast<double>(p.nFluid);
    EXPECT_NEAR(mass, 1000 * 2 * pi / 3, 1e-9);
    EXPECT_NEAR(p.mass, 1, 0.03); // rho0 dx^3: as many cells as the volume holds
    for (std::ptrdiff_t i = 0; i < p.size(); ++i)
    {
        const double R = p.r[i].norm();
        EXPECT_TRUE(i < p.nFluid ? R < 1 && p.r[i].z() < 0 : R > 1 && R < 1.3 + 1e-9) << p.r[i].transpose();
    }
    EXPECT_EQ(missingAround(p, 0.1, {0, 1, 2}, tank), 0);
}

TEST(LatticeSites, PutWallParticlesIntoABodyOfAnyShape)
{
    const Tank tank = Tank::read(Dictionary::parse(
        "plane yz; min (0 0 0); max (1 2 1); fillDepth 0.6; geometry { ball { "
        "type searchableSphere; centre (0 1.02 0.3); radius 0.2; } }",
        "constant/tankProperties"
    ));
    const double dx = 0.02;
    const Particles p = fillTank(tank, dx, 4, 1000, tait, 0, 3.69).particles;
    EXPECT_NEAR(p.mass * static_cast<double>(p.nFluid), 1000 * (1.2 - pi * 0.04), 1e-12 * 1000);
    int inBall = 0;
    for (std::ptrdiff_t i = 0; i < p.size(); ++i)
    {
        const double R = std::hypot(p.r[i].y() - 1.02, p.r[i].z() - 0.3);
        inBall += R <= 0.2 ? 1 : 0;
        EXPECT_FALSE(i < p.nFluid && R <= 0.2);
    }
    EXPECT_NEAR(inBall * dx * dx, pi * 0.04, 0.02 * pi * 0.04);
    EXPECT_EQ(missingAround(p, dx, {1, 2}, tank), 0);
    // As thin bodies of a box are.
    EXPECT_THROW(fillTank(tank, 0.12, 4, 1000, tait, 0, 3.69), CaseError);
}

} // namespace
} // namespace slosh
