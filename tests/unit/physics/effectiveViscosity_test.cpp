// SPDX-License-Identifier: GPL-3.0-or-later
// The kinematic viscosities that the dissipations act like. benchmarks/effectiveViscosity measures more of them.
#include "pairBlock.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace slosh
{
namespace
{

constexpr double alpha = 0.03;

enum class Along
{
    axis,    ///< of the lattice, which the wave shears
    diagonal ///< strains it along its axes
};

/// The unit vectors along k and along v of a wave across k.
std::pair<Vec, Vec> directionsOf(Along along)
{
    const double s = std::sqrt(0.5);
    return along == Along::axis ? std::pair<Vec, Vec>(Vec(0, 0, 1), Vec(1, 0, 0))
                                : std::pair<Vec, Vec>(Vec(s, 0, s), Vec(s, 0, -s));
}

/// nu of v = speed sin(k . r) across k on a lattice of sites dx apart, by dA/dt = -nu k^2 A at once; `rows` sites along
/// an axis have all phases.
template <int dim, class K, class Viscosity>
double onLattice(Along along, double h, int rows, const Viscosity& viscosity, double speed = 1)
{
    const auto [kDirection, vDirection] = directionsOf(along);
    const Vec k = 2 * std::numbers::pi / (rows * dx) * (along == Along::axis ? 1 : std::sqrt(2.0)) * kDirection;
    const int reach = static_cast<int>(std::ceil(K::supportRatio * h / dx));
    Particles particles;
    std::vector<Vec> sites;
    std::vector<std::size_t> column;
    for (int l = -reach; l < rows + reach; ++l)
    {
        for (int j = dim == 3 ? -reach : 0; j <= (dim == 3 ? reach : 0); ++j)
        {
            for (int i = -reach; i <= reach; ++i)
            {
                if (i == 0 && j == 0 && l >= 0 && l < rows)
                {
                    column.push_back(sites.size());
                }
                sites.push_back(Vec(i, j, l) * dx);
            }
        }
    }
    particles.resize(static_cast<std::ptrdiff_t>(sites.size()), 0);
    particles.mass = rho0 * std::pow(dx, dim);
    particles.spacing = dx;
    particles.r = sites;
    for (std::size_t i = 0; i < sites.size(); ++i)
    {
        particles.v[i] = speed * std::sin(k.dot(sites[i])) * vDirection;
        particles.rho[i] = rho0;
        particles.id[i] = static_cast<int>(i);
    }
    const std::vector<Vec> acceleration = viscousPart<dim, K, double>(particles, h, viscosity);
    double rate = 0;
    for (const std::size_t i : column)
    {
        rate += 2.0 / rows * acceleration[i].dot(vDirection) * std::sin(k.dot(sites[i]));
    }
    return -rate / (k.squaredNorm() * speed);
}

ArtificialViscosity artificial()
{
    return {alpha, c0, rho0, 7};
}

/// What Monaghan's formula acts like in a continuum where all pairs count and 0.01 h^2 is left out, [m^2/s].
double unitOf(int dim, double h)
{
    return alpha * h * c0 / (2 * (dim + 2));
}

/// The same sum over a lattice for an infinitely long wave, all pairs, over unitOf(2, h): s along k, t along v,
///   -4 sum_b V_b (1/r) dW/dr s^2 t^2/(r^2 + 0.01 h^2).
double longWaveSum(const Kernel& kernel, Along along)
{
    const auto [kDirection, vDirection] = directionsOf(along);
    const double h = kernel.smoothingLength();
    const int reach = static_cast<int>(std::ceil(kernel.supportRadius() / dx));
    double sum = 0;
    for (int i = -reach; i <= reach; ++i)
    {
        for (int l = -reach; l <= reach; ++l)
        {
            const Vec r = Vec(i, 0, l) * dx;
            const double product = r.dot(kDirection) * r.dot(vDirection);
            sum -= 4 * dx * dx * kernel.gradFactor(r.norm()) * product * product / (r.squaredNorm() + 0.01 * h * h);
        }
    }
    return sum;
}

/// The figures of docs/theory.md, h = 1.23 dx: what approaching pairs alone leave of unitOf.
template <class K>
void expectFiguresOnLattice(double shear, double strain)
{
    const double h = 1.23 * dx;
    for (const auto& [along, figure] : {std::pair(Along::axis, shear), std::pair(Along::diagonal, strain)})
    {
        const double nu = onLattice<2, K>(along, h, 100, artificial());
        EXPECT_NEAR(nu / unitOf(2, h), figure, 0.01 * figure) << K::name;
        EXPECT_NEAR(nu / unitOf(2, h), longWaveSum(Kernel(K{}, 2, h), along) / 2, 0.005) << K::name;
        // Pairs that mirror each other in the direction of k approach and part: the switch takes exactly half.
        const double ofAll = onLattice<2, K>(along, h, 100, LaminarViscosity{unitOf(2, h)});
        EXPECT_NEAR(nu / ofAll, 0.5, 1e-10) << K::name;
    }
}

TEST(LongEffectiveViscosity, OfTheArtificialOneOnALatticeIsAsMeasured)
{
    expectFiguresOnLattice<CubicSpline>(0.407, 0.580);
    expectFiguresOnLattice<WendlandC2>(0.383, 0.571);
    expectFiguresOnLattice<QuinticSpline>(0.460, 0.532);
    expectFiguresOnLattice<ImprovedGaussian>(0.455, 0.537);
    expectFiguresOnLattice<TaperedGaussian>(0.420, 0.570);
}

TEST(LongEffectiveViscosity, OfTheArtificialOneIn3DIsAsMeasured)
{
    for (const auto& [along, figure] : {std::pair(Along::axis, 0.430), std::pair(Along::diagonal, 0.593)})
    {
        const double nu = onLattice<3, ImprovedGaussian>(along, dx, 80, artificial());
        EXPECT_NEAR(nu / unitOf(3, dx), figure, 0.01 * figure);
    }
}

/// nu over unitOf(2, h) in a continuum: the power per mass that a term takes from a shear flow of rate 1 at any angle,
/// by midpoints of radius and direction of the pairs.
template <class K, class Viscosity>
double inContinuum(double angle, const Viscosity& viscosity)
{
    constexpr int radii = 1000, angles = 360;
    const double h = 0.0123;
    const Vec s(-std::sin(angle), std::cos(angle), 0), t(std::cos(angle), std::sin(angle), 0);
    const auto Pi = viscosity.template inLoop<double>(2, h);
    double sum = 0;
    for (int i = 0; i < radii; ++i)
    {
        const double dq = K::supportRatio / radii, q = (i + 0.5) * dq;
        double ring = 0;
        for (int j = 0; j < angles; ++j)
        {
            const double phi = 2 * std::numbers::pi * (j + 0.5) / angles;
            const Vec x(q * std::cos(phi), q * std::sin(phi), 0);
            Neighbour<2, double> a{}, b{};
            a.s = b.s = 1 / rho0;
            for (std::size_t d = 0; d < 2; ++d)
            {
                a.v[d] = h * s.dot(x) * t[static_cast<int>(d)];
            }
            const Pair<2, double, false> pair{a, b, {x[0], x[1]}, q * q, a.v[0] * x[0] + a.v[1] * x[1]};
            ring += Pi(pair, pair.approach) * pair.approach;
        }
        sum += ring / angles * 2 * std::numbers::pi * q * dq * K::dfByQ(q * q);
    }
    return rho0 * K::alpha(2) / (2 * h) * sum / unitOf(2, h);
}

/// 1 less what 0.01 h^2 takes: -pi int W' q^2 q^2/(q^2 + 0.01) dq.
template <class K>
double radialIntegral()
{
    constexpr int radii = 1000;
    double sum = 0;
    for (int i = 0; i < radii; ++i)
    {
        const double dq = K::supportRatio / radii, q = (i + 0.5) * dq, q2 = q * q;
        sum -= std::numbers::pi * K::alpha(2) * K::dfByQ(q2) * q * q2 * q2 / (q2 + 0.01) * dq;
    }
    return sum;
}

template <class K>
void expectHalfInContinuum()
{
    const double all = radialIntegral<K>();
    EXPECT_NEAR(all, 0.99, 0.01) << K::name;
    for (const double angle : {0.0, 0.3, std::numbers::pi / 4})
    {
        const double h = 0.0123;
        EXPECT_NEAR(inContinuum<K>(angle, artificial()), all / 2, 1e-3 * all) << K::name;
        EXPECT_NEAR(inContinuum<K>(angle, LaminarViscosity{unitOf(2, h)}), all, 1e-3 * all) << K::name;
    }
    // What a lattice comes to as h/dx grows: in shear as in strain.
    for (const Along along : {Along::axis, Along::diagonal})
    {
        const double h = 4 * dx;
        const double nu = onLattice<2, K>(along, h, 200, artificial());
        EXPECT_NEAR(nu / unitOf(2, h), all / 2, 0.01 * all / 2) << K::name;
    }
}

TEST(LongEffectiveViscosity, OfTheArtificialOneInAContinuumIsHalfOfThatOverAllPairs)
{
    expectHalfInContinuum<CubicSpline>();
    expectHalfInContinuum<WendlandC2>();
    expectHalfInContinuum<QuinticSpline>();
    expectHalfInContinuum<ImprovedGaussian>();
    expectHalfInContinuum<TaperedGaussian>();
}

TEST(LongEffectiveViscosity, OfTheRiemannTermGrowsWithTheSpeedAndNotWithThatOfSound)
{
    const double h = 1.23 * dx, k = 2 * std::numbers::pi / (100 * dx), slow = c0 / 100;
    for (const Along along : {Along::axis, Along::diagonal})
    {
        const auto nu = [&](double speed, double ofSound)
        { return onLattice<2, ImprovedGaussian>(along, h, 100, LowDissipationRiemann{ofSound}, speed); };
        const double waveNumber = along == Along::axis ? k : std::sqrt(2.0) * k;
        EXPECT_NEAR(nu(slow, c0) / (h * h * waveNumber * slow), 0.14, 0.01);
        EXPECT_NEAR(nu(2 * slow, c0) / nu(slow, c0), 2, 1e-6);
        EXPECT_NEAR(nu(slow, 2 * c0) / nu(slow, c0), 1, 1e-6);
    }
}

/// A disordered block without walls.
template <class Velocity>
Particles freeBlock(const Velocity& velocity)
{
    const Particles inTank = block(2, 20, 0.2);
    Particles particles;
    particles.resize(inTank.nFluid, 0);
    particles.mass = inTank.mass;
    particles.spacing = inTank.spacing;
    for (std::size_t i = 0; i < particles.r.size(); ++i)
    {
        particles.r[i] = inTank.r[i];
        particles.rho[i] = inTank.rho[i];
        particles.v[i] = velocity(inTank, i);
        particles.id[i] = static_cast<int>(i);
    }
    return particles;
}

template <class Viscosity>
void expectLawsOfMotion(const Viscosity& viscosity)
{
    const double h = 1.23 * dx;
    const auto largestAndSum = [&](const auto& velocity)
    {
        double largest = 0;
        Vec sum = Vec::Zero();
        for (const Vec& a : viscousPart<2, ImprovedGaussian, double>(freeBlock(velocity), h, viscosity))
        {
            largest = std::max(largest, a.norm());
            sum += a;
        }
        return std::pair(largest, sum.norm());
    };
    const auto [random, momentum] = largestAndSum([](const Particles& p, std::size_t i) { return p.v[i]; });
    EXPECT_GT(random, 0) << Viscosity::name;
    EXPECT_LT(momentum, 1e-12 * random) << Viscosity::name;
    const auto sheared = largestAndSum([](const Particles& p, std::size_t i) { return Vec(p.r[i].z(), 0, 0); });
    const auto turned =
        largestAndSum([](const Particles& p, std::size_t i) { return Vec(p.r[i].z(), 0, -p.r[i].x()); });
    EXPECT_LT(turned.first, 1e-12 * sheared.first) << Viscosity::name;
}

TEST(LongEffectiveViscosity, KeepsMomentumAndLeavesARigidRotationAlone)
{
    expectLawsOfMotion(artificial());
    expectLawsOfMotion(LaminarViscosity{0.02});
    expectLawsOfMotion(LowDissipationRiemann{c0});
}

} // namespace
} // namespace slosh
