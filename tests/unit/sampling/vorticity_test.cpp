// SPDX-License-Identifier: GPL-3.0-or-later
// The liquid's vorticity in flows whose curl is known.
#include "sampling/vorticity.hpp"

#include "dictionary/Dictionary.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace slosh
{
namespace
{

constexpr double dx = 0.05;

/// A block of n^dim particles in the xz plane or in space, each a little off its place in the lattice.
Particles blockMoving(int dim, int n, const std::function<Vec(const Vec&)>& velocity)
{
    Particles particles;
    particles.resize(dim == 2 ? n * n : n * n * n, 0);
    particles.mass = 1000 * std::pow(dx, dim);
    particles.spacing = dx;
    std::size_t a = 0;
    for (int i = 0; i < n; ++i)
    {
        for (int j = 0; j < (dim == 2 ? 1 : n); ++j)
        {
            for (int k = 0; k < n; ++k, ++a)
            {
                const double off = 0.1 * dx * std::sin(7.0 * i + 3.0 * j + 5.0 * k);
                particles.r[a] = {i * dx + off, dim == 2 ? 0 : j * dx - off, k * dx + off / 2};
                particles.v[a] = velocity(particles.r[a]);
                particles.rho[a] = 1000;
                particles.id[a] = static_cast<int>(a);
            }
        }
    }
    return particles;
}

Scene sceneOf(const std::string& kernel, int dim)
{
    return {
        Tank::read(Dictionary::parse(
            std::string("min (0 0 0); max (1 1 1); fillDepth 0.5; ") + (dim == 2 ? "plane xz;" : ""),
            "constant/tankProperties"
        )),
        Kernel::read(Dictionary::parse("kernel " + kernel + ";", "constant/kernelProperties"), dim, dx),
        SolidBodyMotion::stationary(),
        Vec::Zero(),
        {1000, 10, 7}};
}

std::vector<Vec> vorticityOf(const Particles& particles, const Scene& scene)
{
    return std::get<std::vector<Vec>>(vorticity(particles, scene).values);
}

TEST(Vorticity, OfARigidRotationIsTwiceItsRateUpToTheSurfaceIn2DAnd3D)
{
    const Vec rate(0.3, -0.7, 0.4);
    for (const std::string& name : Kernel::names())
    {
        const Particles turning3D = blockMoving(3, 8, [&](const Vec& r) { return rate.cross(r); });
        for (const Vec& omega : vorticityOf(turning3D, sceneOf(name, 3)))
        {
            EXPECT_NEAR((omega - 2 * rate).norm(), 0, 1e-12) << name;
        }
        const Particles turning2D = blockMoving(2, 12, [](const Vec& r) { return Vec(0, 1.5, 0).cross(r); });
        for (const Vec& omega : vorticityOf(turning2D, sceneOf(name, 2)))
        {
            EXPECT_NEAR((omega - Vec(0, 3, 0)).norm(), 0, 1e-12) << name;
        }
    }
}

TEST(Vorticity, OfAShearIsItsRateAndOfAPureStrainNone)
{
    const Scene scene = sceneOf("improvedGaussian", 2);
    const Particles sheared = blockMoving(2, 12, [](const Vec& r) { return Vec(2 * r.z(), 0, 0); });
    for (const Vec& omega : vorticityOf(sheared, scene))
    {
        EXPECT_NEAR((omega - Vec(0, 2, 0)).norm(), 0, 1e-12); // dvx/dz - dvz/dx
    }
    const Particles strained = blockMoving(2, 12, [](const Vec& r) { return Vec(r.x(), 0, -r.z()); });
    for (const Vec& omega : vorticityOf(strained, scene))
    {
        EXPECT_NEAR(omega.norm(), 0, 1e-12);
    }
}

TEST(Vorticity, OfALoneParticleAndOfWallsIsNone)
{
    Particles particles = blockMoving(2, 1, [](const Vec&) { return Vec(1, 0, 2); });
    particles.resize(1, 1);
    particles.r[1] = particles.r[0] + Vec(dx, 0, 0);
    for (const Vec& omega : vorticityOf(particles, sceneOf("cubicSpline", 2)))
    {
        EXPECT_EQ(omega, Vec(0, 0, 0));
    }
}

} // namespace
} // namespace slosh
