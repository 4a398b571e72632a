// SPDX-License-Identifier: GPL-3.0-or-later
// Every compiled loop against plain sums in double over all pairs.
#include "pairBlock.hpp"

#include "physics/makeInteractions.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include <tuple>

namespace slosh
{
namespace
{

constexpr double alpha = 0.1, nu = 0.02, delta = 0.1;

const std::vector<ViscosityChoice>& viscosities()
{
    static const std::vector<ViscosityChoice> all = {
        NoViscosity{}, ArtificialViscosity{alpha, c0, rho0, 7}, LaminarViscosity{nu}, LowDissipationRiemann{c0}};
    static_assert(std::variant_size_v<ViscosityChoice> == 4);
    return all;
}

const std::vector<DensityDiffusionChoice>& diffusions()
{
    static const std::vector<DensityDiffusionChoice> all = {
        NoDensityDiffusion{}, FourtakasDensityDiffusion{delta, c0, rho0, 7}};
    static_assert(std::variant_size_v<DensityDiffusionChoice> == 2);
    return all;
}

/// Pi_ab as the headers print it.
double Pi(std::size_t which, int dim, double h, double rhoA, double rhoB, const Vec& r, const Vec& v)
{
    const double vr = v.dot(r), distance2 = r.squaredNorm() + 0.01 * h * h;
    switch (which)
    {
    case 1:
        return vr < 0 ? -alpha * h * c0 * (2 + 3 * ((rhoA + rhoB) / rho0 - 2)) * vr / ((rhoA + rhoB) * distance2) : 0;
    case 2:
        return -4 * (dim + 2) * nu * vr / ((rhoA + rhoB) * distance2);
    case 3:
    {
        const double U = std::max(-vr / r.norm(), 0.0);
        return U * std::min(3 * U, c0) * (1 / rhoA + 1 / rhoB) / 2;
    }
    default:
        return 0;
    }
}

/// All sums in double over all pairs, without a body force.
struct Plain
{
    std::vector<Vec> acceleration, viscous, wallAcceleration;
    std::vector<double> densityRate, diffusion, wallDensityRate;

    Plain(const Particles& particles, const Kernel& kernel, std::size_t viscosity, bool diffuses, bool wallsSlip)
        : acceleration(particles.nFluid, Vec::Zero()), viscous(acceleration), wallAcceleration(acceleration),
          densityRate(particles.nFluid), diffusion(densityRate), wallDensityRate(densityRate)
    {
        const double h = kernel.smoothingLength(), m = particles.mass;
        for (std::ptrdiff_t a = 0; a < particles.nFluid; ++a)
        {
            for (std::ptrdiff_t b = 0; b < particles.size(); ++b)
            {
                const Vec r = particles.r[a] - particles.r[b], v = particles.v[a] - particles.v[b];
                if (a == b || r.norm() >= kernel.supportRadius())
                {
                    continue;
                }
                const bool isWall = b >= particles.nFluid;
                const double rhoA = particles.rho[a], rhoB = particles.rho[b];
                const Vec gradW = kernel.gradFactor(r.norm()) * r;
                const Vec pressure = -m * (particles.p[a] / (rhoA * rhoA) + particles.p[b] / (rhoB * rhoB)) * gradW;
                const double compression = rhoA * m / rhoB * v.dot(gradW);
                acceleration[a] += pressure;
                densityRate[a] += compression;
                if (isWall)
                {
                    wallAcceleration[a] += pressure;
                    wallDensityRate[a] += compression;
                }
                if (!isWall || !wallsSlip)
                {
                    const Vec dissipation = -m * Pi(viscosity, kernel.dim(), h, rhoA, rhoB, r, v) * gradW;
                    viscous[a] += dissipation;
                    acceleration[a] += dissipation;
                }
                if (diffuses && !isWall)
                {
                    const double D = -2 * delta * h * c0 * m * rho0 * rhoA / rhoB * (1 / rhoA - 1 / rhoB) *
                                     r.dot(gradW) / r.squaredNorm();
                    diffusion[a] += D;
                    densityRate[a] += D;
                }
            }
        }
    }
};

double sizeOf(double x)
{
    return std::abs(x);
}
double sizeOf(const Vec& x)
{
    return x.norm();
}

/// The largest difference of two fields over the larger of what the second has and `scale`.
template <class T>
double difference(const std::vector<T>& one, const std::vector<T>& other, double scale = 0)
{
    double most = 0, largest = scale;
    for (std::size_t i = 0; i < other.size(); ++i)
    {
        most = std::max(most, sizeOf(one[i] - other[i]));
        largest = std::max(largest, sizeOf(other[i]));
    }
    return largest > 0 ? most / largest : most;
}

class EveryLoop : public testing::TestWithParam<std::tuple<std::string, int, Precision>>
{
};

TEST_P(EveryLoop, IsThePlainSum)
{
    const auto& [name, dim, precision] = GetParam();
    Particles particles = block(dim, dim == 2 ? 14 : 7, 0.2);
    const Kernel kernel(Kernel::choiceNamed(name), dim, 1.2 * dx);
    const double tolerance = precision == Precision::single ? 3e-5 : 1e-11;
    for (std::size_t viscosity = 0; viscosity < viscosities().size(); ++viscosity)
    {
        for (const bool diffuses : {false, true})
        {
            const bool wallsSlip = diffuses; // with each of both
            const auto pairs = makeInteractions(
                {dim, directionsOf(dim), kernel.smoothingLength()}, kernel.choice(),
                {viscosities()[viscosity], diffusions()[diffuses ? 1 : 0], wallsSlip}, precision
            );
            SCOPED_TRACE(pairs->description());
            ClusterLists list;
            list.build(particles, listed(dim), 1.1 * kernel.supportRadius());
            pairs->listBuilt(particles, list, dx);
            std::vector<WallContact> contact;
            // Walls that may pull show their own velocity, zero.
            pairs->see(list, {BodyForce(), {rho0, c0, 7}, true}, nullptr, particles, contact);
            const Plain plain(particles, kernel, viscosity, diffuses, wallsSlip);

            Rates both, one, walls;
            for (Rates* rates : {&both, &one, &walls})
            {
                rates->resize(particles.nFluid);
            }
            pairs->rates(Wanted::both, list, particles, BodyForce(), both);
            pairs->rates(Wanted::acceleration, list, particles, BodyForce(), one);
            EXPECT_EQ(one.densityRate.front(), 0) << "not asked for";
            pairs->rates(Wanted::densityRate, list, particles, BodyForce(), one);
            for (const Rates* rates : {&both, &one})
            {
                EXPECT_LT(difference(rates->acceleration, plain.acceleration), tolerance);
                EXPECT_LT(difference(rates->densityRate, plain.densityRate), tolerance);
                EXPECT_LT(difference(rates->diffusion, plain.diffusion, 1), 2 * tolerance);
            }
            std::vector<Vec> viscous(particles.nFluid, Vec::Zero());
            pairs->budgetParts(false, list, particles, viscous, walls);
            EXPECT_LT(difference(viscous, plain.viscous, 1), tolerance);
            for (int k = 0; k < 2; ++k)
            {
                EXPECT_LT(difference(walls.acceleration, plain.wallAcceleration), tolerance);
                EXPECT_LT(difference(walls.densityRate, plain.wallDensityRate), tolerance);
                pairs->budgetParts(true, list, particles, viscous, walls);
            }
        }
    }
}

TEST_P(EveryLoop, OfWallsAndOfMovingLeastSquaresIsThePlainSum)
{
    const auto& [name, dim, precision] = GetParam();
    Particles particles = block(dim, dim == 2 ? 14 : 7, 0.2);
    const Kernel kernel(Kernel::choiceNamed(name), dim, 1.2 * dx);
    const double tolerance = precision == Precision::single ? 3e-5 : 1e-11;
    const auto pairs =
        makeInteractions({dim, directionsOf(dim), kernel.smoothingLength()}, kernel.choice(), {}, precision);
    ClusterLists list;
    list.build(particles, listed(dim), 1.1 * kernel.supportRadius());
    pairs->listBuilt(particles, list, dx);
    const Vec g(1, 0, -9.81);
    std::vector<WallContact> contact(particles.nWall);
    std::vector<double> p = particles.p;
    pairs->see(list, {BodyForce::gravity(g), {rho0, c0, 7}, true}, nullptr, particles, contact);
    for (std::ptrdiff_t w = particles.nFluid; w < particles.size(); ++w)
    {
        double W = 0, sum = 0;
        Vec v = Vec::Zero();
        for (std::ptrdiff_t f = 0; f < particles.nFluid; ++f)
        {
            const Vec r = particles.r[w] - particles.r[f];
            const double W_wf = kernel.W(r.norm());
            W += W_wf;
            sum += (particles.p[f] + particles.rho[f] * g.dot(r)) * W_wf;
            v += particles.v[f] * W_wf;
        }
        p[w] = W > 0 ? sum / W : 0;
        if (W * particles.mass / rho0 > 1e-3) // else rounding decides
        {
            EXPECT_NEAR(contact[w - particles.nFluid].share, W * particles.mass / rho0, 3 * tolerance);
            EXPECT_LT((contact[w - particles.nFluid].velocity - v / W).norm(), 100 * tolerance);
            EXPECT_NEAR(particles.p[w], p[w], 100 * tolerance * 5000);
        }
    }

    // A density that is linear in space is what moving least squares keep.
    for (std::ptrdiff_t i = 0; i < particles.size(); ++i)
    {
        particles.rho[i] = rho0 * (1 + 0.1 * particles.r[i].x() - 0.3 * particles.r[i].z());
    }
    Particles liquidAlone = particles; // whose densities see() would choose
    const auto linear =
        makeInteractions({dim, directionsOf(dim), kernel.smoothingLength()}, kernel.choice(), {}, precision);
    liquidAlone.resize(particles.nFluid, 0);
    ClusterLists liquid;
    liquid.build(liquidAlone, listed(dim), 1.1 * kernel.supportRadius());
    linear->listBuilt(liquidAlone, liquid, dx);
    std::vector<WallContact> none;
    linear->see(liquid, {BodyForce(), {rho0, c0, 7}, true}, nullptr, liquidAlone, none);
    std::vector<double> rho = liquidAlone.rho;
    linear->movingLeastSquares(liquid, liquidAlone, rho);
    for (std::ptrdiff_t i = 0; i < liquidAlone.nFluid; ++i)
    {
        EXPECT_NEAR(rho[i] / liquidAlone.rho[i], 1, precision == Precision::single ? 3e-5 : 1e-10);
    }
}

std::string nameOf(const testing::TestParamInfo<EveryLoop::ParamType>& info)
{
    const auto& [name, dim, precision] = info.param;
    const char* const words[] = {"single", "double", "reference"};
    return name + "_" + std::to_string(dim) + "D_" + words[static_cast<int>(precision)];
}

auto loopsOf(const std::vector<std::string>& kernels)
{
    return testing::Combine(
        testing::ValuesIn(kernels), testing::Values(2, 3),
        testing::Values(Precision::single, Precision::doublePrecision, Precision::reference)
    );
}

/// The paper's kernel, and the others: the loops are one template.
constexpr const char* papers = "improvedGaussian";

std::vector<std::string> otherKernels()
{
    std::vector<std::string> names = Kernel::names();
    names.erase(std::remove(names.begin(), names.end(), papers), names.end());
    return names;
}

INSTANTIATE_TEST_SUITE_P(OfThePapersKernel, EveryLoop, loopsOf({papers}), nameOf);
INSTANTIATE_TEST_SUITE_P(LongOfTheOtherKernels, EveryLoop, loopsOf(otherKernels()), nameOf);

} // namespace
} // namespace slosh
