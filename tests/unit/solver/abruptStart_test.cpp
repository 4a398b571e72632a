// SPDX-License-Identifier: GPL-3.0-or-later
// Liquid whose tank takes up a velocity at once, against the potential flow of that.
#include "solver/abruptStart.hpp"

#include "dictionary/Dictionary.hpp"
#include "filling/fillTank.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace slosh
{
namespace
{

constexpr double L = 0.2, H = 0.1, rho0 = 1000;

/// Of a tank 0 < x < L, 0 < z < H that begins to move at 1 m/s along x: the velocity of the liquid relative to it.
/// phi = sum a_n sinh k_n (x - L/2) cos k_n z, k_n = (n + 1/2) pi/H, is zero on z = H and has phi_x = 1 at x = 0, L.
Vec exactly(const Vec& X)
{
    Vec u(-1, 0, 0);
    for (int n = 0; n < 60; ++n)
    {
        const double k = (n + 0.5) * std::numbers::pi / H;
        const double a = 2 * (n % 2 == 0 ? 1 : -1) / (H * k * k * std::cosh(k * L / 2));
        u.x() += a * k * std::cosh(k * (X.x() - L / 2)) * std::cos(k * X.z());
        u.z() -= a * k * std::sinh(k * (X.x() - L / 2)) * std::sin(k * X.z());
    }
    return u;
}

struct Tank2D
{
    double dx;
    Scene scene{
        Tank::read(Dictionary::parse(
            "type box; plane xz; min (0 0 0); max (0.2 1 0.2); fillDepth 0.1;", "constant/tankProperties"
        )),
        Kernel::read(Dictionary::parse("kernel improvedGaussian;", "constant/kernelProperties"), 2, dx),
        SolidBodyMotion::stationary(),
        Vec(0, 0, -9.81),
        {rho0, 12, 7},
        {}};
    Particles particles = fillTank(scene.tank, dx, 4, rho0, scene.equationOfState, 9.81, 3.69).particles;

    explicit Tank2D(double spacing) : dx(spacing) {}
    void setVelocity(const Vec& v) { std::fill(particles.v.begin(), particles.v.begin() + particles.nFluid, v); }
    /// Root mean square of the velocity's error.
    double error() const
    {
        double sum = 0;
        for (std::ptrdiff_t i = 0; i < particles.nFluid; ++i)
        {
            sum += (particles.v[i] - exactly(particles.r[i])).squaredNorm();
        }
        return std::sqrt(sum / particles.nFluid);
    }
};

TEST(AbruptStart, TendsToPotentialFlow)
{
    std::vector<double> errors;
    for (const double dx : {0.01, 0.005})
    {
        Tank2D tank(dx);
        tank.setVelocity(Vec(-1, 0, 0));
        const AbruptStart done = startAbruptly(tank.scene, tank.particles);
        EXPECT_GT(done.steps, 50);
        EXPECT_NEAR(done.energyBefore, 0.5, 1e-12);
        EXPECT_LT(done.energyAfter, 0.5);
        errors.push_back(tank.error());
    }
    EXPECT_LT(errors[0], 0.08); // most of it where walls meet the surface: the exact velocity grows as the logarithm
    EXPECT_NEAR(std::log2(errors[0] / errors[1]), 0.75, 0.25);
}

TEST(AbruptStart, IsLinearAndChangesNothingButVelocities)
{
    Tank2D once(0.01);
    Particles before = once.particles;
    once.setVelocity(Vec(-1, 0, 0));
    Tank2D faster(0.01);
    faster.setVelocity(Vec(-20, 0, 0)); // faster than sound
    startAbruptly(once.scene, once.particles);
    startAbruptly(faster.scene, faster.particles);
    double largest = 0;
    for (std::size_t i = 0; i < once.particles.v.size(); ++i)
    {
        largest = std::max(largest, (faster.particles.v[i] / 20 - once.particles.v[i]).norm());
    }
    EXPECT_LT(largest, 1e-9);
    EXPECT_EQ(once.particles.r, before.r);
    EXPECT_EQ(once.particles.id, before.id);
    EXPECT_EQ(once.particles.p, before.p);
    EXPECT_EQ(once.particles.rho, before.rho);
}

TEST(AbruptStart, LeavesLiquidAloneThatMovesWithItsTankOrTouchesNoWall)
{
    Tank2D tank(0.01);
    EXPECT_EQ(startAbruptly(tank.scene, tank.particles).steps, 0);

    // Away from the walls nothing changes a common velocity.
    Scene scene = tank.scene.atRest(Vec::Zero());
    scene.tank = Tank::read(Dictionary::parse(
        "type box; plane xz; min (0 0 0); max (0.2 1 0.2); liquid { drop { "
        "type searchableSphere; centre (0.1 0.5 0.1); radius 0.04; } }",
        "constant/tankProperties"
    ));
    Particles particles = fillTank(scene.tank, 0.01, 4, rho0, scene.equationOfState, 0, 3.69).particles;
    std::fill(particles.v.begin(), particles.v.begin() + particles.nFluid, Vec(0.5, 0, 0));
    startAbruptly(scene, particles);
    for (std::ptrdiff_t i = 0; i < particles.nFluid; ++i)
    {
        EXPECT_NEAR(particles.v[i].x(), 0.5, 1e-9);
        EXPECT_NEAR(particles.v[i].z(), 0, 1e-9);
    }
}

} // namespace
} // namespace slosh
