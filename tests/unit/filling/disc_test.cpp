// SPDX-License-Identifier: GPL-3.0-or-later
#include "filling/fillTank.hpp"

#include "dictionary/Dictionary.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace slosh
{
namespace
{

constexpr TaitEquation tait{1000, 20, 7};
constexpr double pi = std::numbers::pi;

/// A disc of radius 15 in spacings of 1, filled to `depth`, without gravity.
struct FilledDisc
{
    Tank tank;
    Filling filling;
    const Particles& p;
    explicit FilledDisc(const std::string& depth)
        : tank(Tank::read(Dictionary::parse(
              "type disc; plane yz; centre (0 0 0); radius 15; extent (-1 1); fillDepth " + depth + ";",
              "constant/tankProperties"
          ))),
          filling(fillTank(tank, 1, 4, 1000, tait, 0, 3.69)), p(filling.particles)
    {
    }
    /// sum_b V W(x - x_b), the Gaussian of smoothing length 1.23, whose integral is 1.
    double sum(const Vec& x) const
    {
        double sum = 0;
        for (const Vec& r : p.r)
        {
            sum += std::exp(-(x - r).squaredNorm() / (1.23 * 1.23));
        }
        return p.mass / 1000 * sum / (pi * 1.23 * 1.23);
    }
};

TEST(LongFilledDisc, HasTheExactMassAndWallsBehindItsFace)
{
    for (const auto& [depth, area] : {std::pair{"15", pi / 2 * 225}, {"30", pi * 225}})
    {
        const FilledDisc disc(depth);
        const double mass = disc.p.mass * static_cast<double>(disc.p.nFluid);
        EXPECT_NEAR(mass / (1000 * area), 1, 1e-12);
        EXPECT_NEAR(disc.p.mass / 1000, 1, 0.003); // as many cells as the area holds
        for (std::ptrdiff_t i = 0; i < disc.p.size(); ++i)
        {
            const double R = disc.p.r[i].norm();
            EXPECT_EQ(disc.p.r[i].x(), 0);
            EXPECT_TRUE(i < disc.p.nFluid ? R < 14.75 + 0.01 : R > 15.5 - 0.01 && R < 19) << disc.p.r[i].transpose();
        }
    }
}

TEST(LongFilledDisc, LeavesTheKernelsSumAsItIsFarFromWalls)
{
    const FilledDisc full("30"), half("15");
    double most = 0;
    for (std::ptrdiff_t i = 0; i < full.p.nFluid; ++i)
    {
        most = std::max(most, std::abs(full.sum(full.p.r[i]) - 1));
    }
    EXPECT_LT(most, 0.01);
    // Of the half full one below the surface's reach.
    most = 0;
    for (std::ptrdiff_t i = 0; i < half.p.nFluid; ++i)
    {
        most = half.p.r[i].z() < -4 ? std::max(most, std::abs(half.sum(half.p.r[i]) - 1)) : most;
    }
    EXPECT_LT(most, 0.01);
}

TEST(FilledDisc, HasNoHoleAndNoTwoParticlesInOnePlace)
{
    const FilledDisc disc("15");
    const auto least = [&](const Vec& x, std::ptrdiff_t without)
    {
        double least = 1e300;
        for (std::ptrdiff_t i = 0; i < disc.p.size(); ++i)
        {
            least = i == without ? least : std::min(least, (disc.p.r[i] - x).norm());
        }
        return least;
    };
    double hole = 0; // the middle of four on a lattice is 0.71 from them
    for (double y = -18; y < 18; y += 0.17)
    {
        for (double z = -18; z < -0.5; z += 0.17)
        {
            const Vec x(0, y, z);
            hole = x.norm() < 18 ? std::max(hole, least(x, -1)) : hole;
        }
    }
    EXPECT_LT(hole, 0.85);
    for (std::ptrdiff_t i = 0; i < disc.p.size(); ++i)
    {
        EXPECT_GT(least(disc.p.r[i], i), 0.7) << disc.p.r[i].transpose();
    }
}

} // namespace
} // namespace slosh
