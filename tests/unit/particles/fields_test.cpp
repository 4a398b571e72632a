// SPDX-License-Identifier: GPL-3.0-or-later
// Named fields over the particles, and sums over the liquid by bricks.
#include "particles/Particles.hpp"
#include "particles/reduce.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>
#include <string>

namespace slosh
{
namespace
{

TEST(Particles, KeepTheFieldsThatAreWantedMakeNewOnesZeroAndDropTheRest)
{
    Particles particles;
    particles.resize(3, 2);
    particles.more = {
        {"kept", ParticleRange::wall, std::vector<double>{1, 2}},
        {"dropped", ParticleRange::liquid, std::vector<int>{7, 8, 9}},
        {"otherType", ParticleRange::liquid, std::vector<int>{7, 8, 9}}};
    particles.remember(
        {{"otherType", ParticleRange::liquid, std::vector<Vec>()}, {"kept", ParticleRange::wall, std::vector<double>()}}
    );
    EXPECT_EQ(particles.more.size(), 2);
    EXPECT_EQ(particles.values<double>("kept")[1], 2);
    EXPECT_EQ(particles.values<Vec>("otherType").size(), 3);
    EXPECT_EQ(particles.values<Vec>("otherType")[2], Vec(0, 0, 0));
    EXPECT_TRUE(particles.values<int>("dropped").empty());
    EXPECT_TRUE(particles.values<int>("kept").empty()); // of another type
}

TEST(Particles, AreResizedAndCountedByTheirList)
{
    Particles particles;
    particles.more = {{"a", ParticleRange::liquid, std::vector<double>()}};
    particles.resize(10, 4);
    EXPECT_EQ(particles.values<double>("a").size(), 10);
    EXPECT_EQ(particles.bytes(), 14 * (2 * sizeof(Vec) + 2 * sizeof(double) + sizeof(int)) + 10 * sizeof(double));
    std::set<std::string> names;
    particles.forEachField([&](const auto& name, ParticleRange, const auto&) { names.insert(name); });
    EXPECT_EQ(names, (std::set<std::string>{"positions", "U", "rho", "p", "origId", "a"}));
}

/// Sums of numbers of very different size: their rounding shows the order.
double term(std::ptrdiff_t i)
{
    return std::pow(10.0, i % 17) * std::sin(static_cast<double>(i));
}

TEST(ReduceLiquid, SumsBrickByBrickWhateverStandsInOtherBricks)
{
    Particles particles;
    particles.resize(1000, 5);
    const auto sumOf = [](std::ptrdiff_t begin, std::ptrdiff_t end) // of a brick, alone
    {
        Particles one;
        one.resize(end - begin, 0);
        return sumOverLiquid(one, [&](std::ptrdiff_t i) { return term(begin + i); });
    };
    particles.bricks = {0, 130, 131, 700, 1000};
    double expected = 0;
    for (std::size_t k = 0; k + 1 < particles.bricks.size(); ++k)
    {
        expected += sumOf(particles.bricks[k], particles.bricks[k + 1]);
    }
    EXPECT_EQ(sumOverLiquid(particles, term), expected);
    particles.bricks.clear();
    EXPECT_NE(sumOverLiquid(particles, term), expected); // another order
    EXPECT_NEAR(sumOverLiquid(particles, term) / expected, 1, 1e-12);
}

TEST(ReduceLiquid, CountsANumberThatIsNoneForInfinite)
{
    Particles particles;
    particles.resize(300, 0);
    EXPECT_EQ(maxOverLiquid(particles, [](std::ptrdiff_t i) { return i == 7 ? 5.0 : 1.0; }), 5);
    EXPECT_EQ(
        maxOverLiquid(particles, [](std::ptrdiff_t i) { return i == 7 ? std::nan("") : 1.0; }),
        std::numeric_limits<double>::infinity()
    );
    Particles none;
    EXPECT_EQ(maxOverLiquid(none, [](std::ptrdiff_t) { return 1.0; }), 0);
}

} // namespace
} // namespace slosh
