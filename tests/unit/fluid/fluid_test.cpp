// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluid/FluidProperties.hpp"
#include "fluid/TaitEquation.hpp"

#include "base/simd.hpp"
#include "dictionary/Dictionary.hpp"

#include <gtest/gtest.h>

namespace slosh
{
namespace
{

TEST(TaitEquation, IsItsOwnInverse)
{
    for (const double gamma : {1.0, 7.0, 4.5})
    {
        const TaitEquation eos{998, 15, gamma};
        for (const double p : {-2000.0, 0.0, 50.0, 3e4, 1e6})
        {
            EXPECT_NEAR(eos.p(eos.rho(p)), p, 1e-8 + 1e-13 * p) << gamma;
        }
        const double h = 1e-3; // c^2 = dp/drho at rho0
        EXPECT_NEAR((eos.p(998 + h) - eos.p(998 - h)) / (2 * h), 15 * 15, 1e-5) << gamma;
    }
}

TEST(TaitEquation, HasTheSeventhRootToTwoUnitsInTheLastPlace)
{
    using D = Simd<double>;
    for (double x = 0.5; x <= 2; x += 1e-4)
    {
        const double expected = std::pow(x, 1.0 / 7);
        EXPECT_NEAR(seventhRoot(x), expected, 4.5e-16);
        EXPECT_EQ(D(seventhRoot(D(x)))[0], seventhRoot(x));
    }
    EXPECT_EQ(seventhRoot(1.0), 1.0) << "p = 0: rho0";
    // One lane out of reach of the steps: all by the power.
    const TaitEquation water{1000, 30, 7};
    const double far = 40 * water.B();
    const D rho = water.rho(D([&](auto lane) { return lane == 1 ? far : 0.0; }));
    EXPECT_NEAR(rho[0], 1000, 1e-12);
    EXPECT_NEAR(rho[1], 1000 * std::pow(41, 1.0 / 7), 1e-9);
}

TEST(TaitEquation, ColumnIsInEquilibriumAndDepthInvertsIt)
{
    for (const double gamma : {1.0, 7.0})
    {
        const TaitEquation eos{1000, 12, gamma};
        EXPECT_EQ(eos.hydrostatic(9.81, 0), 0);
        for (const double d : {0.05, 0.3, 1.0})
        {
            const double h = 1e-5;
            const double slope = (eos.hydrostatic(9.81, d + h) - eos.hydrostatic(9.81, d - h)) / (2 * h);
            EXPECT_NEAR(slope, eos.rho(eos.hydrostatic(9.81, d)) * 9.81, 1e-4);
            EXPECT_NEAR(eos.depth(9.81, eos.hydrostatic(9.81, d)), d, 1e-13);
        }
    }
}

TEST(FluidProperties, ColumnWeighsWhatTheRealOneDoes)
{
    const FluidProperties fluid = FluidProperties::read(Dictionary::parse(
        "rho0 998; equationOfState { speedOfSound 10; } viscosity { type none; }", "constant/fluidProperties"
    ));
    const Tank tank = Tank::read(Dictionary::parse(
        "type box; plane yz; min (-0.5 -0.46 0); max (0.5 0.46 0.62); fillDepth 0.155;", "constant/tankProperties"
    ));
    const TaitEquation eos = fluid.equationOfState(
        tank, Vec(0, 0, -9.81), automaticSpeedOfSound(tank, Vec(0, 0, -9.81), *SolidBodyMotion::stationary())
    );
    EXPECT_LT(eos.rho0, 998);
    EXPECT_NEAR(eos.hydrostatic(9.81, 0.155), 998 * 9.81 * 0.155, 1e-6); // the bottom carries the weight
}

} // namespace
} // namespace slosh
