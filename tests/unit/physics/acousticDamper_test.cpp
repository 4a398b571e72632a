// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/AcousticDamper.hpp"
#include "physics/FourtakasDensityDiffusion.hpp"

#include "base/threads.hpp"
#include "dictionary/Dictionary.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace slosh
{
namespace
{

constexpr double rho0 = 1000, nu = 0.5, length = 0.05;

/// Liquid at the density rho0 on a lattice in a tank of 0.4 x 0.2 m (x 0.2 m), up to a depth.
struct Scene
{
    Tank tank;
    Particles particles;
    Rates rates;

    explicit Scene(double depth, int dim = 2)
        : tank(Tank::read(Dictionary::parse(
              "type box; min (0 -0.1 0); max (0.4 0.1 0.2); fillDepth " + std::to_string(depth) +
                  (dim == 2 ? "; plane xz;" : ";"),
              "constant/tankProperties"
          )))
    {
        constexpr double dx = 0.01;
        std::vector<Vec> sites;
        for (double z = dx / 2; z < depth; z += dx)
        {
            for (double y = dim == 2 ? 0 : -0.1 + dx / 2; y < 0.1; y += dim == 2 ? 1 : dx)
            {
                for (double x = dx / 2; x < 0.4; x += dx)
                {
                    sites.emplace_back(x, y, z);
                }
            }
        }
        const auto n = static_cast<std::ptrdiff_t>(sites.size());
        particles.resize(n, 0);
        particles.r = sites;
        particles.mass = rho0 * std::pow(dx, dim);
        particles.rho.assign(sites.size(), rho0);
        particles.p.assign(sites.size(), 0.0);
        rates.resize(n);
    }
    AcousticDamper damper() const { return AcousticDamper(tank, length, nu, rho0, {}); }
    /// p of the damper alone, after an update.
    std::vector<double> pressure(AcousticDamper& damper, const SolverFrame& frame = {Frame::tank, {}})
    {
        damper.update(particles, frame, rates);
        return pressureNow(damper, frame);
    }
    std::vector<double> pressureNow(const AcousticDamper& damper, const SolverFrame& frame) const
    {
        std::vector<double> p;
        for (const Vec& r : particles.r)
        {
            p.push_back(damper.pressure(frame.toTank(r)));
        }
        return p;
    }
    /// sum_i V_i p_i D_i, what a pressure takes from the liquid, [W], of a slice of unit thickness in 2D.
    double power(const std::vector<double>& p) const
    {
        double sum = 0;
        for (std::size_t i = 0; i < p.size(); ++i)
        {
            sum += particles.mass / rho0 * p[i] * rates.densityRate[i] / rho0;
        }
        return sum;
    }
};

void fillRandomly(std::vector<double>& values, double most)
{
    std::mt19937 random(5);
    std::uniform_real_distribution<double> any(-most, most);
    for (double& value : values)
    {
        value = any(random);
    }
}

TEST(AcousticDamper, IsABulkViscosityWhereAllIsLiquid)
{
    for (const int dim : {2, 3})
    {
        Scene scene(0.2, dim); // up to the roof
        std::fill(scene.rates.densityRate.begin(), scene.rates.densityRate.end(), 3 * rho0);
        AcousticDamper damper = scene.damper();
        const std::vector<double> pressure = scene.pressure(damper);
        for (const double p : pressure)
        {
            EXPECT_NEAR(p, rho0 * nu * 3, 1e-9 * rho0 * nu * 3);
        }
        const double volume = 0.4 * 0.2 * (dim == 3 ? 0.2 : 1);
        EXPECT_NEAR(scene.power(pressure), rho0 * nu * 3 * 3 * volume, 1e-9);
    }
}

TEST(AcousticDamper, DoesNotCountDensityDiffusion)
{
    Scene scene(0.2);
    const auto n = static_cast<std::size_t>(scene.particles.nFluid);
    scene.particles.more = {{FourtakasDensityDiffusion::meanField, ParticleRange::liquid, std::vector<double>(n, 40)}};
    scene.rates.diffusion.assign(n, 100);
    scene.rates.densityRate.assign(n, 60); // the diffusion less its mean
    AcousticDamper damper = scene.damper();
    for (const double p : scene.pressure(damper))
    {
        EXPECT_EQ(p, 0);
    }
}

TEST(AcousticDamper, TakesEnergyWhateverTheStateIs)
{
    Scene scene(0.12);
    std::vector<double> moves(scene.particles.r.size());
    fillRandomly(moves, 0.01);
    for (std::size_t i = 0; i < moves.size(); ++i)
    {
        scene.particles.r[i] += Vec(moves[i], 0, 3 * moves[moves.size() - 1 - i]);
    }
    fillRandomly(scene.rates.densityRate, 1e4);
    AcousticDamper damper = scene.damper();
    EXPECT_GT(scene.power(scene.pressure(damper)), 0);
}

TEST(AcousticDamper, LeavesFilmsAlone)
{
    Scene film(0.02);
    std::fill(film.rates.densityRate.begin(), film.rates.densityRate.end(), 3 * rho0);
    AcousticDamper none = film.damper();
    for (const double p : film.pressure(none))
    {
        EXPECT_EQ(p, 0);
    }
}

TEST(AcousticDamper, HasTheSameBitsAtAnyNumberOfThreadsAndGoesOnWhereItStopped)
{
    Scene scene(0.15, 3);
    fillRandomly(scene.rates.densityRate, 1e4);
    const int usual = threads();
    setThreads(1);
    AcousticDamper first = scene.damper();
    const std::vector<double> one = scene.pressure(first);
    setThreads(4);
    AcousticDamper second = scene.damper();
    EXPECT_EQ(scene.pressure(second), one);
    setThreads(usual);

    const AcousticDamper again(scene.tank, length, nu, rho0, first.state());
    EXPECT_EQ(scene.pressureNow(again, {Frame::tank, RigidState()}), one);
}

TEST(AcousticDamper, BearsPositionsThatAreNoNumberOrFarAway)
{
    Scene scene(0.12);
    scene.particles.r[3] = Vec(std::nan(""), 0, std::nan(""));
    scene.particles.r[4] = Vec(-1e300, 0, 1e300);
    AcousticDamper damper = scene.damper();
    EXPECT_EQ(scene.pressure(damper).size(), scene.particles.r.size());
}

TEST(AcousticDamper, EnclosesWallsOfDeepLiquidAndNotThoseAtItsSurface)
{
    Scene scene(0.15);
    std::fill(scene.rates.densityRate.begin(), scene.rates.densityRate.end(), 0.0);
    AcousticDamper damper = scene.damper();
    const std::vector<Vec> walls = {{0.2, 0, -0.005}, {-0.005, 0, 0.02}, {-0.005, 0, 0.145}, {0.2, 0, 0.205}};
    std::vector<WallContact> contact(walls.size());
    const auto enclosed = [&]
    {
        damper.findEnclosed(walls, contact);
        std::vector<bool> all;
        for (const WallContact& seen : contact)
        {
            all.push_back(seen.enclosed);
        }
        return all;
    };
    EXPECT_EQ(enclosed(), std::vector<bool>(4, false)) << "before anything is known";
    scene.pressure(damper);
    EXPECT_EQ(enclosed(), (std::vector<bool>{true, true, false, false}));

    Scene film(0.02);
    AcousticDamper none = film.damper();
    film.pressure(none);
    none.findEnclosed(walls, contact);
    EXPECT_FALSE(contact[0].enclosed) << "the bottom under a film";
}

TEST(AcousticDamper, IsTheSameInBothFrames)
{
    Scene scene(0.15, 3);
    fillRandomly(scene.rates.densityRate, 1e4);
    AcousticDamper damper = scene.damper();
    const std::vector<double> inTank = scene.pressure(damper);
    RigidState state;
    state.c = Vec(1, 2, 3);
    state.R = Eigen::AngleAxisd(0.4, Vec(1, 1, 1).normalized()).toRotationMatrix();
    for (Vec& r : scene.particles.r)
    {
        r = state.pointToInertial(r);
    }
    const std::vector<double> inertial = scene.pressure(damper, {Frame::inertial, state});
    for (std::size_t i = 0; i < inTank.size(); ++i)
    {
        EXPECT_NEAR(inertial[i], inTank[i], 1e-6);
    }
}

} // namespace
} // namespace slosh
