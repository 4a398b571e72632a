// SPDX-License-Identifier: GPL-3.0-or-later
// The terms that may stand beside Eq. 1: viscosities, density diffusion.
#include "pairBlock.hpp"
#include "physics/bodyForceIn.hpp"

#include <gtest/gtest.h>

#include <functional>

namespace slosh
{
namespace
{

/// The terms beside Eq. 1 as their papers print them, over all pairs.
struct Terms
{
    std::function<Vec(std::size_t a, std::size_t b, const Vec& r, const Vec& v, const Vec& gradW)> acceleration;
    std::function<double(std::size_t a, std::size_t b, const Vec& r, const Vec& gradW)> densityRate;
};

template <int dim>
Rates withTerms(const Particles& particles, const Kernel& kernel, const Terms& terms)
{
    Rates rates = asPrinted<dim>(particles, kernel, 0, 7);
    for (std::ptrdiff_t a = 0; a < particles.nFluid; ++a)
    {
        for (std::ptrdiff_t b = 0; b < particles.size(); ++b)
        {
            const Vec r = particles.r[a] - particles.r[b];
            if (a == b || r.norm() >= kernel.supportRadius())
            {
                continue;
            }
            const Vec gradW = kernel.gradFactor(r.norm()) * r;
            if (terms.acceleration)
            {
                rates.acceleration[a] += terms.acceleration(a, b, r, particles.v[a] - particles.v[b], gradW);
            }
            if (terms.densityRate)
            {
                rates.densityRate[a] += terms.densityRate(a, b, r, gradW);
            }
        }
    }
    return rates;
}

template <int dim>
void expectTermsAsPrinted()
{
    const Particles particles = block(dim, dim == 2 ? 24 : 9, 0.2);
    const Kernel kernel(WendlandC2{}, dim, 1.2 * dx);
    const double h = kernel.smoothingLength(), nu = 0.02;
    const auto& rho = particles.rho;

    Terms laminar;
    laminar.acceleration = [&](std::size_t a, std::size_t b, const Vec& r, const Vec& v, const Vec& gradW) -> Vec
    {
        return particles.mass * 2 * (dim + 2) * nu * 2 / (rho[a] + rho[b]) * v.dot(r) /
               (r.squaredNorm() + 0.01 * h * h) * gradW;
    };
    EXPECT_LT(
        relativeDifference(
            ratesOf<dim, WendlandC2, double>(particles, LaminarViscosity{nu}),
            withTerms<dim>(particles, kernel, laminar)
        ),
        1e-12
    );

    // p* - (p_a + p_b)/2 = rho c0 U min(3 U/c0, 1)/2 with rho = 2 rho_a rho_b/(rho_a + rho_b)...: Pi = 2 p*/(rho_a
    // rho_b)
    Terms riemann;
    riemann.acceleration = [&](std::size_t a, std::size_t b, const Vec& r, const Vec& v, const Vec& gradW) -> Vec
    {
        const double U = std::max(-v.dot(r) / r.norm(), 0.0);
        const double meanRho = (rho[a] + rho[b]) / 2;
        const double pStar = 0.5 * meanRho * c0 * U * std::min(3 * U / c0, 1.0);
        return -particles.mass * 2 * pStar / (rho[a] * rho[b]) * gradW;
    };
    EXPECT_LT(
        relativeDifference(
            ratesOf<dim, WendlandC2, double>(particles, LowDissipationRiemann{c0}),
            withTerms<dim>(particles, kernel, riemann)
        ),
        1e-9
    );

    // Fourtakas' term with gamma = 1, where c is c0 at any density, over the liquid alone, in a tank that turns as
    // well.
    const Vec g(1, 0, -9.81);
    RigidState tank;
    tank.omega = dim == 2 ? Vec(0, 5, 0) : Vec(1, 5, -2);
    tank.omegaDot = dim == 2 ? Vec(0, 30, 0) : Vec(-8, 30, 9);
    for (const RigidState& state : {RigidState(), tank})
    {
        const BodyForce force = bodyForceIn({Frame::tank, state}, g);
        const double delta = 0.1;
        Terms fourtakas;
        fourtakas.densityRate = [&](std::size_t a, std::size_t b, const Vec& r, const Vec& gradW)
        {
            if (b >= static_cast<std::size_t>(particles.nFluid))
            {
                return 0.0;
            }
            const double s_a = 1 / rho[a], s_b = 1 / rho[b];
            const Vec middle = (particles.r[a] + particles.r[b]) / 2;
            const double atRest = -(s_a + s_b) / 2 * force.onRestingLiquid(middle).dot(r) / (c0 * c0);
            return -2 * delta * h * c0 * particles.mass * rho0 * rho[a] * s_b * (s_a - s_b - atRest) * r.dot(gradW) /
                   r.squaredNorm();
        };
        Rates expected = withTerms<dim>(particles, kernel, fourtakas);
        for (std::size_t i = 0; i < expected.acceleration.size(); ++i)
        {
            Vec b = force.onLiquid(particles.r[i], particles.v[i]);
            b.y() = dim == 2 ? 0 : b.y();
            expected.acceleration[i] += b;
        }
        EXPECT_LT(
            relativeDifference(
                ratesOf<dim, WendlandC2, double>(
                    particles, NoViscosity{}, FourtakasDensityDiffusion{delta, c0, rho0, 1}, force
                ),
                expected
            ),
            1e-12
        );
    }
}

TEST(PairTerms, AreThoseOfTheirPapers)
{
    expectTermsAsPrinted<2>();
    expectTermsAsPrinted<3>();
}

template <class Viscosity, class Diffusion>
void expectPrecisionsAgree(const Viscosity& viscosity, const Diffusion& diffusion)
{
    const Particles particles = block(3, 10, 0.2);
    const BodyForce force = BodyForce::gravity(Vec(1, 2, -9.81));
    const Rates reference = ratesOf<3, WendlandC2, double>(particles, viscosity, diffusion, force);
    EXPECT_LT(
        (relativeDifference(
            ratesOf<3, WendlandC2, SimdOfRows<float>>(particles, viscosity, diffusion, force), reference
        )),
        2e-5
    );
    EXPECT_LT(
        (relativeDifference(
            ratesOf<3, WendlandC2, SimdOfRows<double>>(particles, viscosity, diffusion, force), reference
        )),
        1e-12
    );
}

/// Along walls that slip a viscosity is what it would be if the liquid were alone.
template <int dim, class Viscosity>
void expectSlipLeavesWallsOut(const Viscosity& viscosity)
{
    const Particles particles = block(dim, dim == 2 ? 24 : 9, 0.2);
    Particles liquidAlone = particles;
    liquidAlone.resize(particles.nFluid, 0);
    constexpr double h = 1.2 * dx;
    const auto difference = [](const std::vector<Vec>& one, const std::vector<Vec>& other)
    {
        double most = 0, largest = 0;
        for (std::size_t i = 0; i < one.size(); ++i)
        {
            most = std::max(most, (one[i] - other[i]).norm());
            largest = std::max(largest, other[i].norm());
        }
        return most / largest;
    };
    const auto expected = viscousPart<dim, WendlandC2, double>(liquidAlone, h, viscosity);
    EXPECT_LT(difference(viscousPart<dim, WendlandC2, double>(particles, h, viscosity, true), expected), 1e-12)
        << Viscosity::name;
    EXPECT_GT(difference(viscousPart<dim, WendlandC2, double>(particles, h, viscosity, false), expected), 1e-3)
        << Viscosity::name;
    // Some lanes of a vector take part.
    EXPECT_LT(
        difference(viscousPart<dim, WendlandC2, SimdOfRows<float>>(particles, h, viscosity, true), expected), 2e-5
    ) << Viscosity::name;
}

TEST(PairTerms, OfViscositiesLeaveWallsThatSlipOut)
{
    expectSlipLeavesWallsOut<2>(ArtificialViscosity{0.03, c0, rho0, 7});
    expectSlipLeavesWallsOut<3>(ArtificialViscosity{0.03, c0, rho0, 7});
    expectSlipLeavesWallsOut<2>(LaminarViscosity{0.02});
    expectSlipLeavesWallsOut<3>(LaminarViscosity{0.02});
    expectSlipLeavesWallsOut<2>(LowDissipationRiemann{c0});
    expectSlipLeavesWallsOut<3>(LowDissipationRiemann{c0});
}

TEST(FourtakasDensityDiffusion, KeepsTheVolumeOfTheLiquid)
{
    // sum m d(1/rho)/dt = -sum m D/rho^2 over a tank that turns, whatever the densities, beside walls.
    RigidState tank;
    tank.omega = Vec(1, 5, -2);
    tank.omegaDot = Vec(-8, 30, 9);
    const BodyForce force = bodyForceIn({Frame::tank, tank}, Vec(1, 2, -9.81));
    Particles particles = block(3, 10, 0.2);
    for (double& rho : particles.rho)
    {
        rho = rho0 + (rho - rho0) / 10; // by 1e-3, as in a liquid
    }
    const auto D =
        ratesOf<3, WendlandC2, double>(particles, NoViscosity{}, FourtakasDensityDiffusion{0.1, c0, rho0, 7}, force)
            .diffusion;
    double sum = 0, sizes = 0;
    for (std::size_t i = 0; i < D.size(); ++i)
    {
        const double volume = -D[i] / (particles.rho[i] * particles.rho[i]);
        sum += volume;
        sizes += std::abs(volume);
    }
    EXPECT_LT(std::abs(sum), 1e-5 * sizes);
    EXPECT_GT(sizes, 0);
}

TEST(PairTerms, OfFloatAndDoubleVectorsAgreeWithTheScalarReference)
{
    const NoDensityDiffusion none;
    expectPrecisionsAgree(LaminarViscosity{0.02}, none);
    expectPrecisionsAgree(LowDissipationRiemann{c0}, none);
    expectPrecisionsAgree(NoViscosity{}, FourtakasDensityDiffusion{0.1, c0, rho0, 7});
}

TEST(FourtakasDensityDiffusion, LeavesLiquidAtRestInAnAcceleratedTankAlone)
{
    // c0^2 (rho/rho0)^(gamma - 1) d rho = rho b . dr, integrated.
    constexpr double gamma = 7;
    Particles particles = block(2, 24, 0.0);
    const Vec b(3, 0, -9.81);
    for (std::size_t i = 0; i < particles.r.size(); ++i)
    {
        particles.rho[i] = rho0 * std::pow(1 + (gamma - 1) * b.dot(particles.r[i]) / (c0 * c0), 1 / (gamma - 1));
        particles.v[i].setZero();
    }
    const FourtakasDensityDiffusion diffusion{0.1, c0, rho0, gamma};
    const auto largest = [&](const BodyForce& force)
    {
        double most = 0;
        for (const double D : ratesOf<2, WendlandC2, double>(particles, NoViscosity{}, diffusion, force).densityRate)
        {
            most = std::max(most, std::abs(D));
        }
        return most;
    };
    EXPECT_LT(largest(BodyForce::gravity(b)), 2e-4 * largest(noForce()));
}

} // namespace
} // namespace slosh
