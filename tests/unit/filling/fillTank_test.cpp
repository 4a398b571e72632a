// SPDX-License-Identifier: GPL-3.0-or-later
#include "filling/fillTank.hpp"
#include "filling/initialFields.hpp"

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

const std::string rolling = "type box; plane yz; min (-0.5 -0.46 0); max (0.5 0.46 0.62); fillDepth 0.155; ";
constexpr TaitEquation tait{1000, 20, 7};

TEST(FillTank, HoldsTheExactMassWhateverTheSpacing)
{
    const Tank tank = tankOf(rolling);
    for (const double dx : {0.155 / 15, 0.01, 0.0123, 0.031})
    {
        const Filling filling = fillTank(tank, dx, 4, 998, tait, 9.81, 3.69);
        const Particles& p = filling.particles;
        EXPECT_NEAR(p.mass * static_cast<double>(p.nFluid), 998 * 0.92 * 0.155, 1e-11) << dx;
        for (std::ptrdiff_t i = 0; i < p.nFluid; ++i)
        {
            EXPECT_GT(tank.distanceToWall(p.r[static_cast<std::size_t>(i)]), 0.4 * dx * 0.9);
        }
        for (std::ptrdiff_t i = p.nFluid; i < p.size(); ++i)
        {
            EXPECT_LT(tank.distanceToWall(p.r[static_cast<std::size_t>(i)]), 0);
        }
    }
    EXPECT_TRUE(fillTank(tankOf("type box; min (0 0 0); max (1 1 1); fillDepth 0.5;"), 0.1, 4, 998, tait, 0, 2)
                    .adjustments.empty());
    EXPECT_FALSE(fillTank(tank, 0.0123, 4, 998, tait, 9.81, 3.69).adjustments.empty());
}

TEST(FillTank, SurroundsTheLiquidWithTheLayersAskedFor)
{
    // 1 x 1 x 0.5 of 0.1: 10 x 10 x 5 liquid cells in a closed shell of L layers around 10 x 10 x 10.
    const Tank tank = tankOf("type box; min (0 0 0); max (1 1 1); fillDepth 0.5;");
    for (const int layers : {1, 3, 4})
    {
        const Particles p = fillTank(tank, 0.1, layers, 1000, tait, 0, 2).particles;
        EXPECT_EQ(p.nFluid, 500);
        const long edge = 10 + 2 * layers;
        EXPECT_EQ(p.nWall, edge * edge * edge - 1000);
    }
}

TEST(FillTank, StartsWithThePressureOfTheColumn)
{
    const Tank tank = tankOf(rolling);
    const Particles p = fillTank(tank, 0.155 / 15, 4, 1000, tait, 9.81, 3.69).particles;
    for (std::size_t i = 0; i < static_cast<std::size_t>(p.nFluid); ++i)
    {
        const double depth = 0.155 - p.r[i].z();
        EXPECT_NEAR(p.p[i], 1000 * 9.81 * depth, 0.01 * 1000 * 9.81 * 0.155);
        EXPECT_NEAR(p.rho[i], tait.rho(p.p[i]), 1e-9);
        EXPECT_EQ(p.v[i], Vec(0, 0, 0));
    }
}

TEST(FillTank, MakesADropInFreeSpaceSymmetricAndOfExactMass)
{
    const Tank tank = tankOf("type box; min (-2 -2 -2); max (2 2 2); "
                             "liquid { drop { type searchableSphere; centre (0 0 0); radius 1; } }");
    const Filling filling = fillTank(tank, 0.1, 0, 998, tait, 0, 3);
    const Particles& p = filling.particles;
    EXPECT_EQ(p.nWall, 0);
    EXPECT_NEAR(p.mass * static_cast<double>(p.nFluid), 998 * 4.0 / 3.0 * std::acos(-1.0), 1e-9);
    Vec centre = Vec::Zero();
    for (const Vec& r : p.r)
    {
        EXPECT_LT(r.norm(), 1);
        centre += r;
    }
    EXPECT_LT(centre.norm(), 1e-9);
    EXPECT_NEAR(p.spacing, 0.1, 2e-3);
}

TEST(FillTank, RefusesWhatTheKernelCannotSee)
{
    const Tank thin = tankOf(rolling + "geometry { b { type searchableBox; min (-1 -0.01 0); max (1 0.01 0.1); } }");
    EXPECT_THROW(fillTank(thin, 0.01, 4, 1000, tait, 9.81, 3.69), CaseError);
    EXPECT_NO_THROW(fillTank(thin, 0.005, 4, 1000, tait, 9.81, 3.69));
    EXPECT_THROW(fillTank(tankOf(rolling), 0.5, 4, 1000, tait, 9.81, 3.69), CaseError);
}

TEST(InitialFields, AreFormulasInTheTanksCoordinates)
{
    const Tank tank = tankOf("type box; plane xz; min (-2 0 -2); max (2 1 2); "
                             "liquid { patch { type searchableSphere; centre (0 0 0); radius 1; } }");
    Particles p = fillTank(tank, 0.1, 0, 1000, tait, 0, 3).particles;
    const auto set = [&](const std::string& text)
    { setInitialFields(Dictionary::parse(text, "system/blockParticlesDict/initialFields"), tank, tait, p); };
    set("U (\"-2*x\" \"17\" \"2*z + sqr(x)\"); p \"500*(1 - x^2 - z^2)\";");
    for (std::size_t i = 0; i < p.r.size(); ++i)
    {
        const double x = p.r[i].x(), z = p.r[i].z();
        EXPECT_DOUBLE_EQ(p.v[i].x(), -2 * x);
        EXPECT_EQ(p.v[i].y(), 0); // the empty direction
        EXPECT_NEAR(p.v[i].z(), 2 * z + x * x, 1e-14);
        EXPECT_NEAR(p.p[i], 500 * (1 - x * x - z * z), 1e-10);
        EXPECT_NEAR(tait.p(p.rho[i]), p.p[i], 1e-7);
    }
    EXPECT_THROW(set("U (\"x\" \"0\");"), CaseError);
    EXPECT_THROW(set("p \"1/(x - x)\";"), CaseError);
    EXPECT_THROW(set("p \"2*w\";"), CaseError);
    EXPECT_THROW(set("p \"-1e9\";"), CaseError);
    EXPECT_THROW(set("pressure \"1\";"), CaseError);
}

} // namespace
} // namespace slosh
