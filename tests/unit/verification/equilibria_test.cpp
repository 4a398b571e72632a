// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/TaitColumn.hpp"
#include "verification/equilibria.hpp"

#include "base/CaseError.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace slosh
{
namespace
{

/// Of f over [begin, end]: midpoints, exact to degree 1 and to 1e-7 for the parabolas here.
template <class F>
double mean(double begin, double end, const F& f)
{
    constexpr int n = 4000;
    double sum = 0;
    for (int i = 0; i < n; ++i)
    {
        sum += f(begin + (end - begin) * (i + 0.5) / n);
    }
    return sum / n;
}

TEST(TiltedLevel, IsNormalToTheForceAndKeepsTheVolume)
{
    const TiltedLevel level(1, 0.3, 2.4525, 0, 9.81);
    EXPECT_DOUBLE_EQ(level.eta(-0.5), 0.425);
    EXPECT_DOUBLE_EQ(level.eta(0.25), 0.2375);
    EXPECT_DOUBLE_EQ(level.pressure(-0.5, 0, 1000), 4169.25);
    EXPECT_NEAR(mean(-0.5, 0.5, [&](double x) { return level.eta(x); }), 0.3, 1e-14);
    const TiltedLevel lift(1, 0.3, 1, 2, 9.81);
    EXPECT_NEAR(lift.pressure(0.1, 0.1, 1000) - lift.pressure(0.2, 0.1, 1000), 1000 * 1 * 0.1, 1e-10);
    EXPECT_NEAR(lift.pressure(0.1, 0.1, 1000) - lift.pressure(0.1, 0.2, 1000), 1000 * 11.81 * 0.1, 1e-10);
    EXPECT_THROW(TiltedLevel(1, 0.3, 6, 0, 9.81), CaseError);
}

TEST(RotatingLevel, IsAParabolaThatKeepsTheVolume)
{
    const RotatingLevel cylinder = RotatingLevel::cylinder(0.5, 0.3, 3, 9.81);
    EXPECT_NEAR(cylinder.eta(0), 0.24266055, 5e-9);
    EXPECT_NEAR(cylinder.eta(0.5), 0.35733945, 5e-9);
    EXPECT_NEAR(cylinder.pressure(0.5, 0, 1000), 3505.5, 1e-9);
    EXPECT_NEAR(mean(0, 0.5, [&](double r) { return cylinder.eta(r) * 2 * r / 0.5; }), 0.3, 1e-7);

    const RotatingLevel slot = RotatingLevel::slot(1, 0.3, 3, 9.81);
    EXPECT_NEAR(slot.eta(0.25), 0.29044343, 5e-9);
    EXPECT_NEAR(mean(-0.5, 0.5, [&](double x) { return slot.eta(x); }), 0.3, 1e-7);

    const RotatingLevel box = RotatingLevel::box(0.6, 0.4, 0.3, 3, 9.81);
    const auto overX = [&](double y) { return mean(-0.3, 0.3, [&](double x) { return box.eta(std::hypot(x, y)); }); };
    EXPECT_NEAR(mean(-0.2, 0.2, overX), 0.3, 1e-7);
    EXPECT_THROW(RotatingLevel::slot(1, 0.3, 10, 9.81), CaseError);
}

TEST(TaitColumn, CarriesItsOwnWeight)
{
    const TaitColumn column{.h = 0.8, .c0 = 12};
    const double d = 1e-5;
    for (const double y : {0.1, 0.5})
    {
        EXPECT_NEAR((column.pressure(y + d) - column.pressure(y - d)) / (2 * d), -column.density(y) * 9.81, 1e-4);
    }
    EXPECT_EQ(column.pressure(0.8), 0);
    EXPECT_NEAR(mean(0, 0.8, [&](double y) { return column.density(y); }) * 0.8, column.mass(), 1e-5);
    EXPECT_GT(column.pressure(0), 1000 * 9.81 * 0.8 * 1.01);
    const TaitColumn stiff{.h = 0.8, .c0 = 12e3};
    EXPECT_NEAR(stiff.pressure(0.2), 1000 * 9.81 * 0.6, 1e-3);
}

TEST(TaitColumn, ReleasedWithoutPressureSwingsBetweenNothingAndTwiceTheWeight)
{
    const TaitColumn column{.h = 0.8, .c0 = 12};
    const double weight = 1000 * 9.81 * 0.8, period = 4 * 0.8 / 12;
    EXPECT_NEAR(column.releasedPressure(0, 0), 0, 1e-9);
    EXPECT_NEAR(column.releasedPressure(0, period / 2), 2 * weight, 1e-9);
    EXPECT_NEAR(column.releasedPressure(0, period), 0, 1e-9);
    // by the natural modes: p = sum 8 rho g h/(pi n)^2 cos(kappa y)(1 - cos kappa c0 t), kappa = n pi/(2 h), n odd
    for (const double y : {0.0, 0.3, 0.8})
    {
        for (const double t : {0.02, 0.11, 0.9})
        {
            double sum = 0;
            for (int n = 1; n < 20000; n += 2)
            {
                const double kappa = n * std::numbers::pi / (2 * column.h);
                sum += 8 * weight / std::pow(std::numbers::pi * n, 2) * std::cos(kappa * y) *
                       (1 - std::cos(kappa * column.c0 * t));
            }
            EXPECT_NEAR(column.releasedPressure(y, t), sum, 1e-4 * weight);
        }
    }
}

} // namespace
} // namespace slosh
