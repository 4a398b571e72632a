// SPDX-License-Identifier: GPL-3.0-or-later
// The sums over pairs against plain double loops over all pairs, and the properties the equations have.
#include "base/threads.hpp"
#include "pairBlock.hpp"

#include <gtest/gtest.h>

#include <numeric>

namespace slosh
{
namespace
{

template <int dim, class K>
void expectAllPrecisionsAgree()
{
    const Particles particles = block(dim, dim == 2 ? 30 : 11, 0.2);
    const ArtificialViscosity viscosity{0.03, c0, rho0, 7};
    const Rates reference = ratesOf<dim, K, double>(particles, viscosity);
    // What docs/theory.md promises of single precision, and rounding in double.
    EXPECT_LT(relativeDifference(ratesOf<dim, K, SimdOfRows<float>>(particles, viscosity), reference), 2e-5) << K::name;
    EXPECT_LT(relativeDifference(ratesOf<dim, K, SimdOfRows<double>>(particles, viscosity), reference), 1e-12)
        << K::name;
}

TEST(PairRates, OfFloatAndDoubleVectorsAgreeWithTheScalarReference)
{
    forEveryKernel(
        []<class K>()
        {
            expectAllPrecisionsAgree<2, K>();
            expectAllPrecisionsAgree<3, K>();
        }
    );
}

template <int dim>
void expectAsPrinted()
{
    const Particles particles = block(dim, dim == 2 ? 24 : 9, 0.2);
    const Kernel kernel(ImprovedGaussian{}, dim, 1.2 * dx);
    const Rates inviscid = ratesOf<dim, ImprovedGaussian, double>(particles, NoViscosity{});
    EXPECT_LT(relativeDifference(inviscid, asPrinted<dim>(particles, kernel, 0, 7)), 1e-12);
    // gamma = 3: c is linear in rho, and the linearised speed of sound is exact.
    const Rates linear = ratesOf<dim, ImprovedGaussian, double>(particles, ArtificialViscosity{0.1, c0, rho0, 3});
    EXPECT_LT(relativeDifference(linear, asPrinted<dim>(particles, kernel, 0.1, 3)), 1e-12);
    // gamma = 7: off by what the header says, and not by nothing.
    const Rates tait = ratesOf<dim, ImprovedGaussian, double>(particles, ArtificialViscosity{0.1, c0, rho0, 7});
    const double difference = relativeDifference(tait, asPrinted<dim>(particles, kernel, 0.1, 7));
    EXPECT_LT(difference, 3e-4);
    EXPECT_GT(difference, 1e-9);
}

TEST(PairRates, AreTheEquationsAsThePaperPrintsThem)
{
    expectAsPrinted<2>();
    expectAsPrinted<3>();
}

TEST(PairRates, ConserveMomentumAmongLiquidParticles)
{
    Particles particles = block(2, 20, 0.2);
    particles.resize(particles.nFluid, 0); // resizing keeps the liquid, which stands first
    const Rates rates = ratesOf<2, WendlandC2, double>(particles, ArtificialViscosity{0.03, c0, rho0, 7});
    Vec sum = Vec::Zero();
    double largest = 0;
    for (const Vec& a : rates.acceleration)
    {
        sum += a;
        largest = std::max(largest, a.norm());
    }
    EXPECT_LT(sum.norm(), 1e-11 * largest);
}

TEST(ArtificialViscosity, WithAlphaZeroIsNoViscosity)
{
    const Particles particles = block(2, 16, 0.2);
    const Rates none = ratesOf<2, QuinticSpline, double>(particles, NoViscosity{});
    const Rates zero = ratesOf<2, QuinticSpline, double>(particles, ArtificialViscosity{0, c0, rho0, 7});
    EXPECT_EQ(relativeDifference(zero, none), 0);
}

TEST(ArtificialViscosity, TakesEnergyFromTheLiquid)
{
    const Particles particles = block(3, 8, 0.2);
    const Rates with = ratesOf<3, WendlandC2, double>(particles, ArtificialViscosity{0.1, c0, rho0, 7});
    const Rates without = ratesOf<3, WendlandC2, double>(particles, NoViscosity{});
    double power = 0;
    for (std::size_t i = 0; i < with.acceleration.size(); ++i)
    {
        power += particles.v[i].dot(with.acceleration[i] - without.acceleration[i]);
    }
    EXPECT_LT(power, 0);
}

TEST(PairRates, AskedForOneAtATimeAreTheSame)
{
    const Particles particles = block(2, 20, 0.2);
    const ArtificialViscosity viscosity{0.03, c0, rho0, 7};
    const FourtakasDensityDiffusion diffusion{0.1, c0, rho0, 7};
    const Rates both = ratesOf<2, WendlandC2, double>(particles, viscosity, diffusion);
    const Rates first =
        ratesOf<2, WendlandC2, double>(particles, viscosity, diffusion, noForce(), false, Wanted::acceleration);
    Rates second =
        ratesOf<2, WendlandC2, double>(particles, viscosity, diffusion, noForce(), false, Wanted::densityRate);
    EXPECT_EQ(second.acceleration.front(), Vec(Vec::Zero())) << "not asked for";
    second.acceleration = first.acceleration;
    EXPECT_LT(relativeDifference(second, both), 1e-14);
}

TEST(PairRates, HaveTheSameBitsAtAnyNumberOfThreads)
{
    const Particles particles = block(2, 60, 0.2);
    const int before = threads();
    std::vector<Rates> rates;
    for (const int threads : {1, 2, 3, 4})
    {
        setThreads(threads);
        rates.push_back(
            ratesOf<2, ImprovedGaussian, SimdOfRows<float>>(particles, ArtificialViscosity{0.03, c0, rho0, 7})
        );
    }
    setThreads(before);
    for (std::size_t k = 1; k < rates.size(); ++k)
    {
        EXPECT_EQ(rates[k].densityRate, rates[0].densityRate);
        for (std::size_t i = 0; i < rates[0].acceleration.size(); ++i)
        {
            EXPECT_EQ(rates[k].acceleration[i], rates[0].acceleration[i]);
        }
    }
}

TEST(ClusterRecords, ResolveATankOf4096SpacingsInFloatAsInDouble)
{
    // The same block at the far end of a tank 4096 spacings long.
    Particles particles = block(2, 20, 0.2);
    for (Vec& r : particles.r)
    {
        r.x() += 4096 * dx;
    }
    particles.r.front() = Vec(0, 0, 0);
    const ArtificialViscosity viscosity{0.03, c0, rho0, 7};
    EXPECT_LT(
        relativeDifference(
            ratesOf<2, ImprovedGaussian, SimdOfRows<float>>(particles, viscosity),
            ratesOf<2, ImprovedGaussian, double>(particles, viscosity)
        ),
        2e-5
    );
}

constexpr TaitEquation tait{rho0, c0, 7};

template <class S>
void expectWallTakesHydrostaticPressure(double tolerance)
{
    Particles particles = block(2, 24, 0.0);
    const Vec g(0.7, 0, -9.81); // a tank that also accelerates to the left
    const auto pressure = [&](const Vec& r) { return 5000 + rho0 * g.dot(r); };
    for (std::size_t i = 0; i < particles.r.size(); ++i)
    {
        particles.rho[i] = rho0;
        particles.p[i] = static_cast<std::ptrdiff_t>(i) < particles.nFluid ? pressure(particles.r[i]) : 0;
    }
    Sums<2, ImprovedGaussian, S> sums(particles, 1.23 * dx);
    std::vector<WallContact> contact(particles.nWall);
    sums.pairs.see(sums.lists, {BodyForce::gravity(g), tait, false}, nullptr, particles, contact);
    int inSupport = 0;
    for (std::ptrdiff_t i = particles.nFluid; i < particles.size(); ++i)
    {
        if (particles.p[i] > 0)
        {
            ++inSupport;
            EXPECT_NEAR(particles.p[i], pressure(particles.r[i]), tolerance);
        }
    }
    EXPECT_EQ(inSupport, 3 * 24); // layers at 1, 2, 3 dx; the fourth is out of 3.69 dx
}

TEST(WallPressure, IsExactWhereTheLiquidsPressureIsLinearInSpace)
{
    expectWallTakesHydrostaticPressure<double>(1e-9);
    expectWallTakesHydrostaticPressure<SimdOfRows<double>>(1e-9);
    expectWallTakesHydrostaticPressure<SimdOfRows<float>>(0.02);
}

/// Asks the walls for their pressure; the velocity that they show, by particle.
std::vector<Vec> askWalls(bool suction, Particles& particles, const Vec& g = Vec::Zero())
{
    Sums<2, WendlandC2, double> sums(particles, 1.23 * dx);
    std::vector<WallContact> none;
    sums.pairs.see(sums.lists, {BodyForce::gravity(g), tait, suction}, nullptr, particles, none);
    std::vector<Vec> shown = particles.v;
    const Clusters& walls = sums.lists.walls();
    for (const int cluster : sums.lists.wallsInReach())
    {
        for (int lane = 0; lane < walls.pointsIn(cluster); ++lane)
        {
            // After two positions.
            const double* v = sums.pairs.records().ofWalls(cluster) + 2 * clusterSize + lane;
            shown[particles.nFluid + walls.point(walls.firstPlace(cluster) + lane)] = Vec(v[0], 0, v[clusterSize]);
        }
    }
    return shown;
}

TEST(WallPressure, BesideASurfaceIsThatOfTheLiquidGoneOnBeyondIt)
{
    Particles particles = block(2, 12, 0.0);
    // Upward; the surface, p = 0, is half a spacing beyond the first row, the wall beyond the surface.
    const double g = 9.81;
    const auto pressure = [&](const Vec& r) { return rho0 * g * (r.z() + 0.5 * dx); };
    for (std::ptrdiff_t i = 0; i < particles.nFluid; ++i)
    {
        particles.rho[i] = rho0;
        particles.p[i] = pressure(particles.r[i]);
    }
    const std::vector<Vec> shown = askWalls(false, particles, g * Vec::UnitZ());
    const auto nearest = static_cast<std::size_t>(particles.size() - 6); // of the topmost layer
    EXPECT_LT(pressure(particles.r[nearest]), 0);
    EXPECT_NEAR(particles.p[nearest], pressure(particles.r[nearest]), 1e-9);
    EXPECT_EQ(shown[nearest], particles.v[nearest]);
}

/// A block of liquid on a wall, all of it at the pressure p and the velocity v.
Particles blockOnWall(double p, const Vec& v)
{
    Particles particles = block(2, 12, 0.0);
    std::fill(particles.p.begin(), particles.p.end(), p);
    std::fill(particles.rho.begin(), particles.rho.end(), rho0);
    std::fill_n(particles.v.begin(), particles.nFluid, v);
    return particles;
}

TEST(WallPressure, PullsOnlyWhereSuctionIsAllowed)
{
    Particles pulling = blockOnWall(-5000, Vec::Zero());
    Particles particles = pulling;
    const auto nearest = static_cast<std::size_t>(particles.size() - 6); // of the topmost layer
    askWalls(true, pulling);
    EXPECT_NEAR(pulling.p[nearest], -5000, 1e-8);
    askWalls(false, particles);
    EXPECT_NEAR(particles.p[nearest], 5000, 1e-8); // p_f + p_w = 0: neither pulls nor pushes
}

/// The largest density rate in a block of liquid that moves as a whole beside a wall, over rho0 |v|/dx.
double stretching(double p, bool suction, const Vec& v)
{
    Particles particles = blockOnWall(p, v);
    const std::vector<Vec> shown = askWalls(suction, particles);
    particles.v = shown;
    std::fill_n(particles.v.begin(), particles.nFluid, v);
    const Rates rates = ratesOf<2, WendlandC2, double>(particles, NoViscosity{});
    double largest = 0;
    // Away from the wall's ends, where it is no plane.
    for (std::ptrdiff_t i = 0; i < particles.nFluid; ++i)
    {
        if (particles.r[i].x() > 4.5 * dx && particles.r[i].x() < 6.5 * dx)
        {
            largest = std::max(largest, std::abs(rates.densityRate[i]));
        }
    }
    return largest / (rho0 * v.norm() / dx);
}

TEST(WallPressure, LiquidThatLeavesAWallIsNotStretched)
{
    const Vec leaving(0.2, 0, 1), coming(0.2, 0, -1);
    EXPECT_LT(stretching(0, false, leaving), 1e-12);
    EXPECT_LT(stretching(-5000, false, leaving), 1e-12);
    // A wall that pushes or may pull, and one that liquid comes to, is felt.
    EXPECT_GT(stretching(5000, false, leaving), 0.1);
    EXPECT_GT(stretching(-5000, true, leaving), 0.1);
    EXPECT_GT(stretching(-5000, false, coming), 0.1);
}

template <int dim, class S>
void expectLinearDensityKept(double tolerance)
{
    // Volumes m/rho of a disordered block do not fill space evenly, which is what moving least squares correct.
    Particles particles = block(dim, dim == 2 ? 20 : 9, 0.2);
    const auto density = [](const Vec& r) { return rho0 * (1 + 0.1 * r.x() - 0.2 * r.y() - 0.3 * r.z()); };
    for (std::size_t i = 0; i < particles.r.size(); ++i)
    {
        particles.rho[i] = density(particles.r[i]);
    }
    const Sums<dim, ImprovedGaussian, S> sums(particles, 1.23 * dx);
    std::vector<double> rho = particles.rho;
    sums.pairs.movingLeastSquares(sums.lists, particles, rho);
    for (std::ptrdiff_t i = 0; i < particles.nFluid; ++i)
    {
        EXPECT_NEAR(rho[i], density(particles.r[i]), tolerance) << "particle " << i;
    }
}

TEST(MovingLeastSquares, KeepADensityThatIsLinearInSpaceUpToTheFreeSurface)
{
    expectLinearDensityKept<2, double>(1e-8);
    expectLinearDensityKept<3, double>(1e-8);
    expectLinearDensityKept<2, SimdOfRows<double>>(1e-8);
    expectLinearDensityKept<2, SimdOfRows<float>>(0.02);
    expectLinearDensityKept<3, SimdOfRows<float>>(0.02);
}

TEST(MovingLeastSquares, KeepTheDensityOfParticlesAloneInPairsAndInALine)
{
    Particles particles;
    particles.resize(6, 0);
    particles.mass = rho0 * dx * dx;
    particles.r = {Vec(0, 0, 0), Vec(1, 0, 0), Vec(1, 0, dx), Vec(2, 0, 0), Vec(2 + dx, 0, 0), Vec(2 + 2 * dx, 0, 0)};
    particles.rho.assign(6, 1004);
    std::iota(particles.id.begin(), particles.id.end(), 0);
    const Sums<2, WendlandC2, SimdOfRows<double>> sums(particles, 1.23 * dx);
    std::vector<double> rho = particles.rho;
    sums.pairs.movingLeastSquares(sums.lists, particles, rho);
    for (const double value : rho)
    {
        EXPECT_NEAR(value, 1004, 1e-9);
    }
}

} // namespace
} // namespace slosh
